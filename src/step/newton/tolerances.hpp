// Defines every tolerance and limit of the searches for a balance of forces, with the reason for each.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock::tolerances {

/// Newton iterations in statics, under load or arc-length control.
namespace of_newton {

// Residual of a balanced state, relative to the largest force.
inline constexpr double kBalanced = 1e-9;
// Near a limit load the regions of plastic flow change with each iteration; searches of 30 iterations were seen to
// succeed.
inline constexpr int kMostRounds = 40;
// Fraction of the elastic stiffness in the tangent of a second attempt; ten times as much was seen to double the
// iterations.
inline constexpr double kElasticShare = 1e-3;

}  // namespace of_newton

/// Line searches.
namespace of_line_search {

// Required fall, as a fraction of the predicted one, and number of halvings: 1/256 would make no progress.
inline constexpr double kLeastFall = 0.1;
inline constexpr int kMostHalvings = 8;
// Change of an iteration relative to the last: above kStalls it makes no progress, below kLeads much progress. A part p
// of an increment predicts a reduction by p, of which kPromised suffices. kLeastPart is the smallest part.
inline constexpr double kStalls = 0.7;
inline constexpr double kLeads = 0.25;
inline constexpr double kPromised = 0.9;
inline constexpr double kLeastPart = 1.0 / 16;

}  // namespace of_line_search

/// Smooth motion of a step, whose iterations end by the size of their changes.
namespace of_smooth_motion {

// Increments converge if they change by less than this fraction of block size: a hundred times round-off of a position.
inline constexpr double kSettled = 1e-12;
// Usually one to three iterations suffice. A change below kTolerable after the last one is accepted; the next step
// closes the remaining gap error. A larger change is a failure, unless the forces fit the gaps of the last iteration.
// They may, because a small force for a heavy block moves a light one far.
inline constexpr int kMostRounds = 8;
inline constexpr int kMostRoundsOfSprings = 30;  // their law is not linear where they close or open
inline constexpr int kMostRoundsOfYield = 40;    // points change sides of their surface between iterations
// Elastoplastic rock is stiff relative to its strength. If the strength is 1e-5 of the modulus, this change of strain
// changes the stress by 1e-4 of the strength.
inline constexpr double kTolerableOfYield = 1e-9;
inline constexpr double kTolerable = 1e-6;
// Iterations with tolerable changes that new tangents did not reduce; with round-off every second is one.
inline constexpr int kStallsOfRoundOff = 3;
// Rows and matrix are updated in the first iterations, and later if the estimate moved by more than kSameRows.
// Directions of forces are then that accurate. Gaps always come from the estimate itself.
inline constexpr int kMostRows = 2;
inline constexpr double kSameRows = 1e-9;
// With few pairs updates cost almost nothing, and forces then do their work along the path of the step to the last
// digits.
inline constexpr double kSameRowsOfFew = kSettled;
// In assemblies rows may be as inaccurate as forces are. Forces that meet the gaps of the last estimate within
// kGoalsOfEstimate times their goal, 1e-5 of the heaviest load, are not solved again. The error left is that fraction
// of the free fall of a step.
inline constexpr double kSameRowsOfMany = 1e-5;
inline constexpr double kGoalsOfEstimate = 10;
inline constexpr double kOfLast = 2;
// The matrix of NMM bodies is kept while an iteration leaves less than this fraction of the last change.
inline constexpr double kWorstGain = 0.03;
// Increments that differ by less share one tangent. With elements of a thousandth of a body the tangent differs by a
// thousand times that, far below the required gain. An update would cost one linear solve per contact force.
inline constexpr double kSameTangent = 1e-6;

}  // namespace of_smooth_motion

/// Dynamic steps: cuts, and tolerances of contact forces.
namespace of_steps {

inline constexpr int kMostHalvings = 2;
inline constexpr int kMostHalvingsOfYield = 5;  // a long step of flow may find no balance where a short one does
// Number of single impacts at which a step is divided, if contacts are few; later impacts count at the end of the step.
// A part ends kInstant of the step after its impact, which then surely lies inside; no part is shorter.
inline constexpr int kMostImpacts = 4;
inline constexpr double kInstant = 1e-3;
// Each search adds the corners that the last solution made overlap; overlaps left after these searches await the next
// step.
inline constexpr int kMostSearches = 4;
// Residual of contact forces over the largest load on a block. Few contacts reach the first value, assemblies the
// second.
inline constexpr double kForceGoal = 1e-10;
inline constexpr double kForceAcceptable = 1e-6;
// In assemblies of more contacts than `kFewPairs` the goal is a setting, 1e-8, far below the effect of a step on
// forces. The acceptable residual is judged by the response of a force's own blocks within the step. It corresponds to
// a gap of 1e-4 of their free fall, accurate enough to trust a run.
inline constexpr double kForceAcceptableOfMany = 1e-4;
// In the shortest part of a cut step a few pairs among many may keep changing sides. A residual of 1e-2 is accepted, or
// one that changes the largest momentum by 1e-4, and the pairs are reported.
inline constexpr double kForceToleratedOfMany = 1e-2;
inline constexpr double kMomentumToleratedOfMany = 1e-4;
// A smaller force is round-off of gaps in a short step.
inline constexpr double kLeastForceOfMany = 1e-8;
// If nothing loads the blocks, forces come from momentum alone: the same tolerances over momentum / dt.
inline constexpr double kMomentumGoal = 1e-13;
inline constexpr double kMomentumAcceptable = 1e-9;

}  // namespace of_steps

/// Contact forces without impacts.
namespace of_gaps {

// Gaps below this fraction of block size count as closed, and bodies so near as touching. It is far above the rounding
// of files and far below the visible.
inline constexpr double kTouching = 1e-6;
// Faces with strength are bonded if they are drawn within this fraction of block size: coordinates of five digits.
// Bonds keep the gap, so that it never closes. A wider gap was drawn on purpose, and its faces fall on one another.
inline constexpr double kDrawnTogether = 1e-4;
// Forces without springs need not close gaps below this fraction of block size.
inline constexpr double kGapTolerance = 1e-9;
// Round-off of forces is this fraction of the greatest force of the last step: forces of held strain can be far above
// all loads. If nothing loads a scene, no load defines a small force. Forces that the gaps would need one by one then
// count too.
inline constexpr double kRoundOff = 1e-14;
inline constexpr double kFewRoundOffs = 1e-12;
// A bond breaks if it opens by more than this fraction of block size in a step; less is round-off of the solution.
inline constexpr double kBroken = 1e-11;

}  // namespace of_gaps

/// Velocity jumps, and removal of overlaps.
namespace of_impacts {

// An overlap of this fraction of block size is round-off of a position, which two or three linearised passes reach. In
// assemblies the remainder is far below the overlap that the next step removes by itself.
inline constexpr double kNoOverlap = 1e-14;
inline constexpr double kNoOverlapOfMany = 5e-11;
inline constexpr int kMostPasses = 10;
// A body that is hit from two sides may go several times farther than its change of velocity lets it. Beyond this
// factor, impulses that held one another are out of balance: 500 in a jammed slope.
inline constexpr double kBalanced = 10;
// Some overlaps cannot all be removed at once. To find them, the pushes are solved once with every contact softened by
// kYield of the compliance of its blocks, which always has a solution. A contact that keeps more than kLocked of its
// overlap is locked. A pair with room keeps a hundredth, a chain of ten a tenth.
inline constexpr double kYield = 1e-2;
inline constexpr double kLocked = 0.1;
// Impulses converge at this fraction of the largest momentum. A residual kLooser times larger still counts if redundant
// impulses keep the goal out of reach.
inline constexpr double kImpulseTolerance = 1e-13;
inline constexpr double kLooser = 1e4;
// In assemblies impulses converge as well as forces do: to 1e-6 of the largest momentum, or 1e-2 of the largest impulse
// of one impact. The larger value counts. A pair that still approaches at kShareOfSlow of the limit for slow is left to
// the next step.
inline constexpr double kImpulseToleranceOfMany = 1e-6;
inline constexpr double kShareOfImpulse = 1e-2;
inline constexpr double kShareOfSlow = 1e-2;
// The friction of impulses that stop velocities comes from the last iteration. Each iteration leaves an error of
// friction times slenderness.
inline constexpr int kMostFrictionRounds = 5;
inline constexpr double kSmallest = 1e-300;  // a tolerance is never zero

}  // namespace of_impacts

/// Size of steps under step control.
namespace of_step_control {

inline constexpr double kSafety = 0.9;
// The error grows with the third power of the part in smooth motion, with the first power if the part holds an impact.
// This order lies between.
inline constexpr double kOrder = 2;
inline constexpr double kMostGrowth = 2;
inline constexpr double kMostCut = 0.1;
inline constexpr double kUnsolvedCut = 0.25;  // if contact forces do not converge
inline constexpr double kGreatestRatio = 3;   // over the allowed displacement, as in steps of Shi's programs
inline constexpr double kEnd = 1e-9;          // a smaller remainder of an interval is round-off

}  // namespace of_step_control

/// Accelerations that fit closed contacts.
namespace of_accelerations {

// A tangential force nearer to the friction limit than this fraction belongs to a slip.
inline constexpr double kAtLimit = 1e-9;
// Residual over the largest force. Redundant contacts may keep it out of reach; then a residual kLooser times larger
// counts.
inline constexpr double kTolerance = 1e-13;
inline constexpr double kLooser = 1e4;
inline constexpr double kSmallest = 1e-300;  // a tolerance is never zero

}  // namespace of_accelerations

/// Static equilibrium.
namespace of_rest {

// Residual over the largest load: a hundred times the tolerance of contact forces.
inline constexpr double kBalanced = 1e-8;
// Distance of a fixed point from its target over the size of its block: above the tolerance of increments in steps.
inline constexpr double kInPlace = 1e-9;

}  // namespace of_rest

/// Forces of a compatible start.
namespace of_start_forces {

inline constexpr double kForceTolerance = 1e-12;  // of the largest force on a block
inline constexpr double kLooser = 1e6;            // factor of the accepted residual if the goal is out of reach
inline constexpr double kUnbalanced = 1e-9;       // of the greatest acceleration by the loads

// Contact stiffness over the inertia that keeps rigid motion finite while forces are distributed.
inline constexpr double kLong = 1e6;
// Weight of the proximal term over the flexibility of a contact, much less than the elastic part of it.
inline constexpr double kRegular = 1e-7;
// Slip prescribed for a sliding contact, over all others, so that it keeps sliding.
inline constexpr double kBeyond = 1e3;
// Above this fraction of its limit a friction force slides.
inline constexpr double kSliding = 1 - 1e-6;

}  // namespace of_start_forces

/// Shifts of a compatible start.
namespace of_compatible_start {

// Three iterations suffice if statics determines the forces. Otherwise elasticity does, and each iteration reduces the
// misfit several times.
inline constexpr int kStaticRounds = 3;
inline constexpr int kMostRounds = 20;
inline constexpr double kRoundOff = 1e-9;  // fraction of block size, or of acceleration, left by the rounding of files
inline constexpr double kFits = 1e-9;      // misfit over the gaps to be closed
inline constexpr double kShiftTolerance = 1e-13;  // of the gaps to be closed
// A block that shifts by more than this times the sum of all gaps is thrown about, not settled.
inline constexpr double kLeverage = 10;

}  // namespace of_compatible_start

/// Settled start.
namespace of_settled_start {

// Stiffness of the contacts over the mass term that holds unsupported parts. The slowest mode of a mass a thousand
// blocks high has 1e-6 of a contact's stiffness, and the term should not affect it.
inline constexpr double kHeldByNothing = 1e10;
// Compliance of fixed points over that of a contact.
inline constexpr double kRigid = 1e-4;
// Stiffness of the contacts over the inertia of the heaviest block in steps that dissolve the glue. A free block moves
// by half that times its weight over the contact stiffness per step. It grows from step to step while nothing moves
// farther than kFarthest of block size. Glue forces across many blocks redistribute in long steps only: it also grows
// after a step that moved by at most kSettles of free motion and of the step before. A step that moves farther than
// kFarthestOfSettling is made again, shorter by kShorter.
inline constexpr double kShortest = 16;
inline constexpr double kLongest = 1048576;
inline constexpr double kGrowth = 4;
inline constexpr double kFarthest = 1e-4;
inline constexpr double kSettles = 0.5;
inline constexpr double kFarthestOfSettling = 1e-3;
// Steps grow by kGrowthOfHeld if the first one moves by at most kHeld of free motion: friction then carries nearly the
// forces of the glue, as in walls. Near the limit of strength such long steps would jump between equilibria.
inline constexpr double kHeld = 0.25;
inline constexpr double kGrowthOfHeld = 16;
// Such a scene of very many pairs is a large wall. Longer steps take most of the linear systems of its start, and move
// it hardly more. Steps after the search anew are short, since they only have to show that the wall is at rest. Forces
// of a step need to be no better than kOfShare of the last step's fraction of free motion.
inline constexpr double kLongestOfWall = 16384;
inline constexpr double kLastOfWall = 4096;
inline constexpr double kOfShare = 0.01;
// A step is a stall unless its fraction of free motion is below kStalls of the least so far. A scene that stalls
// kMostStalls times in a row has no equilibrium near by, and moves. It then begins where it was before the stalls.
inline constexpr double kStalls = 0.95;
inline constexpr int kMostStalls = 6;
inline constexpr int kMostSteps = 40;
inline constexpr int kMostSearches = 4;
// If a step moves kRises times the last one's fraction of free motion, friction can carry the load in several ways. A
// long step may then find another than the one it came along; it is repeated, shorter by kShorter.
inline constexpr double kRises = 2;
inline constexpr double kShorter = 16;
// A block that moves by less than this fraction of free motion is in equilibrium.
inline constexpr double kAtRest = 2e-5;
// Two steps are equally long if their displacements differ by less than this fraction: the scene then moves under
// constant forces, and is put back to where it was drawn. A slide by more than kFarthestSlide of block size would leave
// contacts behind, and is made again in shorter steps.
inline constexpr double kEvenly = 1e-3;
inline constexpr double kFarthestSlide = 1e-4;
// Residual of the start, over the largest load on a block. All steps of the run inherit it. The goal is far below what
// moves the lightest block: at 1e-6, noise of a nanometre in the drawing moved slivers by 3e-6 m. The second value is
// accepted if the goal is out of reach, and the goal of very many pairs, which pay twice the time for the first. The
// third is accepted for wedged blocks under multipliers, which may have many solutions.
inline constexpr double kForceGoal = 1e-9;
inline constexpr double kForceTolerance = 1e-6;
inline constexpr double kForceTolerated = 1e-3;

}  // namespace of_settled_start

/// Static equilibrium as initial state, found like any other static state.
namespace of_resting_start {

// Iterations of one search. Successful searches take tens; by then a sliding or falling body has moved its own size.
inline constexpr int kMostIterations = 300;
inline constexpr int kMostSearches = 5;  // each leaves out the bodies named by the one before
// Displacement of a vertex over block size up to which a body counts as where it was drawn. The second value applies
// where the next test finds no equilibrium.
inline constexpr double kInPlace = 1e-3;
inline constexpr double kInPlaceUntried = 1e-2;
// Farther bodies are tested at kSmallShare of loads and initial stress. A body that deforms then moves a fraction of
// the way; one that swings or slides to another place moves all of it.
inline constexpr double kSmallShare = 0.1;
inline constexpr double kSameWay = 0.5;

}  // namespace of_resting_start

/// Start of bodies that accelerate.
namespace of_moving_start {

// Free fall in a step of pseudo time over the size of the largest body, or over the greatest change of a length if that
// is more. The sum of these motions is taken back as one rotation of first order, so that it must stay small; a step
// reduces an elastic error by a factor of about 1 + kOverStrain.
inline constexpr double kReach = 1e-4;
inline constexpr double kOverStrain = 3;
inline constexpr int kMostSteps = 60;
inline constexpr double kSettled = 1e-4;    // change of lengths in a step over all change: 1e-3 of the stress is left
inline constexpr double kRoundOff = 2e-15;  // of lengths over the farthest coordinate: ten units of the last place

}  // namespace of_moving_start

/// Proximal point iteration for a static state, whose iterations are steps of pseudo time.
namespace of_statics {

// Residual of contact forces over the largest load: goal, and value accepted at the end. Before the end a fraction of
// the imbalance suffices, as for any inexact proximal point method.
inline constexpr double kForceGoal = 1e-10;
inline constexpr double kForceAcceptable = 1e-9;
inline constexpr double kForceOnTheWay = 1e-6;
// Without any load, forces below this strain of a contact's stiffness over the block size are round-off.
inline constexpr double kNoStrain = 1e-12;
// Displacement of a vertex per iteration over block size: gaps and loads are taken as linear in it.
inline constexpr double kFarthest = 0.05;
inline constexpr double kAimed = 0.5;  // fraction of it for which τ is chosen
inline constexpr double kGrowth = 4;
inline constexpr double kGrowthAfterCut = 1.2;  // once contact forces did not converge under a longer τ
// Longest τ times the slowest frequency of a block. One iteration reduces an elastic error to its inverse square. Joint
// bending of many blocks is slower, and its error falls less.
inline constexpr double kLongest = 3e3;
// In scenes with a body without strain, rigid motion judges the forces; a longer τ would leave springs and gaps
// unjudged.
inline constexpr double kLongestOfRigid = 30;
// Loads that follow the rotation are not linearised. Too large a τ makes a hanging block overshoot its equilibrium,
// more in each iteration. If blocks reverse and the imbalance rises, τ stays below this fraction of the τ that caused
// it.
inline constexpr double kAfterRise = 0.5;
inline constexpr double kRaised = 1.2;  // in each iteration without such a reversal
inline constexpr int kLook = 10;        // iterations between two checks of the imbalance
inline constexpr double kFalls = 0.5;
inline constexpr double kLonger = 2;
// The imbalance is steady if it changes by less than kSame. After kSteady such iterations a block that has moved by
// kFarIfSteady of its size accelerates. It moved so little only because contact forces converge under short τ alone.
inline constexpr double kSame = 1e-3;
inline constexpr int kSteady = 50;
inline constexpr double kFarIfSteady = 1e-2;
inline constexpr double kBalanceAcceptable = 1e-6;  // if no smaller value is reached
inline constexpr int kMostIterations = 2000;
inline constexpr double kBalancedToBegin = 1e-8;  // typical value on success, for the reported progress
inline constexpr int kMostCuts = 20;              // in a row
inline constexpr int kMostSearches = 4;           // each adds corners that the last solution made overlap
// Contacts nearer than this fraction of block size at the start of slip counting were closed at that time.
inline constexpr double kClosedThen = 1e-6;

}  // namespace of_statics

}  // namespace keyblock::tolerances
