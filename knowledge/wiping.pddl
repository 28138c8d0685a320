; What a wiping robot can bring about. Which tool can move which medium on which surface is not
; said here: the (can-...) facts come from the knowledge base.
(define (domain wiping)
  (:requirements :strips :typing)
  (:types tool medium surface)

  (:predicates
    (hand-empty)
    (holding ?t - tool)
    (on ?m - medium ?s - surface)
    (can-absorb ?t - tool ?m - medium ?s - surface)
    (can-collect ?t - tool ?m - medium ?s - surface)
    (can-skim ?t - tool ?m - medium ?s - surface)
    (can-polish ?t - tool ?m - medium ?s - surface)
    (can-dispense ?t - tool ?m - medium ?s - surface)
    (absorbed ?m - medium ?s - surface)
    (collected ?m - medium ?s - surface)
    (skimmed ?m - medium ?s - surface)
    (polished ?m - medium ?s - surface)
    (dispensed ?m - medium ?s - surface))

  (:action grasp
    :parameters (?t - tool)
    :precondition (hand-empty)
    :effect (and (holding ?t) (not (hand-empty))))

  (:action release
    :parameters (?t - tool)
    :precondition (holding ?t)
    :effect (and (hand-empty) (not (holding ?t))))

  (:action absorb
    :parameters (?t - tool ?m - medium ?s - surface)
    :precondition (and (holding ?t) (on ?m ?s) (can-absorb ?t ?m ?s))
    :effect (and (absorbed ?m ?s) (not (on ?m ?s))))

  ; What is collected still lies on the surface, but in one place.
  (:action collect
    :parameters (?t - tool ?m - medium ?s - surface)
    :precondition (and (holding ?t) (on ?m ?s) (can-collect ?t ?m ?s))
    :effect (collected ?m ?s))

  (:action skim
    :parameters (?t - tool ?m - medium ?s - surface)
    :precondition (and (holding ?t) (on ?m ?s) (can-skim ?t ?m ?s))
    :effect (and (skimmed ?m ?s) (not (on ?m ?s))))

  ; What treats a surface brings its medium along.
  (:action polish
    :parameters (?t - tool ?m - medium ?s - surface)
    :precondition (and (holding ?t) (can-polish ?t ?m ?s))
    :effect (polished ?m ?s))

  (:action dispense
    :parameters (?t - tool ?m - medium ?s - surface)
    :precondition (and (holding ?t) (can-dispense ?t ?m ?s))
    :effect (dispensed ?m ?s)))
