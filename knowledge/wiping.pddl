; What a wiping robot can bring about. Which tool can move which medium on which surface is not
; said here: the (can-...) facts come from the knowledge base.
(define (domain wiping)
  (:requirements :strips :typing :negative-preconditions :universal-preconditions :conditional-effects)
  (:types tool medium surface)

  (:predicates
    (hand-empty)
    (holding ?t - tool)
    (loaded ?t - tool)
    (on ?m - medium ?s - surface)
    (wet ?s - surface) ; while a liquid is on the surface: derived, no action states it
    (in-way ?d - medium ?m - medium ?s - surface) ; d is wiped before m
    (under ?d - medium ?m - medium ?s - surface) ; d is off the surface before m treats it
    (sweeps ?t - tool ?m - medium ?o - medium ?s - surface) ; wiping m passes over where o was collected
    (spoiled ?m - medium ?s - surface) ; what was collected has been wiped over
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

  ; A tool that has absorbed something is wrung out or emptied before it is used again.
  (:action empty
    :parameters (?t - tool)
    :precondition (and (holding ?t) (loaded ?t))
    :effect (not (loaded ?t)))

  ; Loose dirt goes before a liquid on the same surface, and polish before a coat: (in-way ...) states it. Nothing may lie
  ; under a treatment, not even in a heap: (under ...) states it.
  (:action absorb
    :parameters (?t - tool ?m - medium ?s - surface)
    :precondition (and (holding ?t) (not (loaded ?t)) (on ?m ?s) (can-absorb ?t ?m ?s)
      (forall (?d - medium) (not (in-way ?d ?m ?s))))
    :effect (and (absorbed ?m ?s) (loaded ?t) (not (on ?m ?s))
      (forall (?o - medium) (when (sweeps ?t ?m ?o ?s) (and (spoiled ?o ?s) (not (collected ?o ?s)))))
      (forall (?o - medium) (and (not (in-way ?m ?o ?s)) (not (under ?m ?o ?s))))))

  ; What is collected still lies on the surface, but in one place: whatever passes over it there spoils it.
  (:action collect
    :parameters (?t - tool ?m - medium ?s - surface)
    :precondition (and (holding ?t) (not (loaded ?t)) (on ?m ?s) (can-collect ?t ?m ?s) (not (spoiled ?m ?s))
      (forall (?d - medium) (not (in-way ?d ?m ?s))))
    :effect (and (collected ?m ?s)
      (forall (?o - medium) (when (sweeps ?t ?m ?o ?s) (and (spoiled ?o ?s) (not (collected ?o ?s)))))
      (forall (?o - medium) (not (in-way ?m ?o ?s)))))

  (:action skim
    :parameters (?t - tool ?m - medium ?s - surface)
    :precondition (and (holding ?t) (not (loaded ?t)) (on ?m ?s) (can-skim ?t ?m ?s)
      (forall (?d - medium) (not (in-way ?d ?m ?s))))
    :effect (and (skimmed ?m ?s) (not (on ?m ?s))
      (forall (?o - medium) (when (sweeps ?t ?m ?o ?s) (and (spoiled ?o ?s) (not (collected ?o ?s)))))
      (forall (?o - medium) (and (not (in-way ?m ?o ?s)) (not (under ?m ?o ?s))))))

  ; What treats a surface brings its medium along.
  (:action polish
    :parameters (?t - tool ?m - medium ?s - surface)
    :precondition (and (holding ?t) (not (loaded ?t)) (can-polish ?t ?m ?s)
      (forall (?d - medium) (and (not (in-way ?d ?m ?s)) (not (under ?d ?m ?s)))))
    :effect (and (polished ?m ?s) (forall (?o - medium) (not (in-way ?m ?o ?s)))
      (forall (?o - medium) (when (sweeps ?t ?m ?o ?s) (and (spoiled ?o ?s) (not (collected ?o ?s)))))))

  (:action dispense
    :parameters (?t - tool ?m - medium ?s - surface)
    :precondition (and (holding ?t) (not (loaded ?t)) (can-dispense ?t ?m ?s)
      (forall (?d - medium) (and (not (in-way ?d ?m ?s)) (not (under ?d ?m ?s)))))
    :effect (and (dispensed ?m ?s)
      (forall (?o - medium) (when (sweeps ?t ?m ?o ?s) (and (spoiled ?o ?s) (not (collected ?o ?s))))))))
