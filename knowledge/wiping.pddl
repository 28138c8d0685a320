; The actions of a wiping robot. The knowledge base states which tool can wipe or dispense which medium on which surface: the
; facts (can-...).
(define (domain wiping)
  (:requirements :strips :typing :negative-preconditions :universal-preconditions :conditional-effects)
  (:types tool medium surface)

  (:predicates
    (hand-empty)
    (holding ?t - tool)
    (loaded ?t - tool)
    (on ?m - medium ?s - surface)
    (wet ?s - surface) ; a liquid is on the surface; wisch derives this fact, no action has it as an effect
    (in-way ?d - medium ?m - medium ?s - surface) ; d has to be wiped before m
    (under ?d - medium ?m - medium ?s - surface) ; d has to be off the surface before m treats it
    (sweeps ?t - tool ?m - medium ?o - medium ?s - surface) ; wiping m with t passes over the heap of o
    (spoiled ?m - medium ?s - surface) ; the heap of m has been wiped over
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

  ; A tool that has absorbed a medium is wrung out or emptied before it is used again.
  (:action empty
    :parameters (?t - tool)
    :precondition (and (holding ?t) (loaded ?t))
    :effect (not (loaded ?t)))

  ; (in-way ...): loose dirt is wiped before a liquid on the same surface, and polishing comes before coating. (under ...):
  ; nothing may lie under a polish or a coat, not even a heap.
  (:action absorb
    :parameters (?t - tool ?m - medium ?s - surface)
    :precondition (and (holding ?t) (not (loaded ?t)) (on ?m ?s) (can-absorb ?t ?m ?s)
      (forall (?d - medium) (not (in-way ?d ?m ?s))))
    :effect (and (absorbed ?m ?s) (loaded ?t) (not (on ?m ?s))
      (forall (?o - medium) (when (sweeps ?t ?m ?o ?s) (and (spoiled ?o ?s) (not (collected ?o ?s)))))
      (forall (?o - medium) (and (not (in-way ?m ?o ?s)) (not (under ?m ?o ?s))))))

  ; Collected dirt stays on the surface, in a heap. A tool that passes over the heap spoils it.
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

  ; Polishing and coating bring their medium along, so it need not be on the surface.
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
