// Every tolerance and limit of a search for a balance of forces, with its reason.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock::tolerances {

/// Of rounds of Newton's method at rest, by load or along the path of equilibria.
namespace of_newton {

// Of the largest of the forces: what may be left of them.
inline constexpr double kBalanced = 1e-9;
// Near a limit load the rock flows in regions that change from round to round: 30 rounds were seen to end well.
inline constexpr int kMostRounds = 40;
// Of the elastic stiffness, in the tangent of a second attempt; ten times as much was seen to double the rounds.
inline constexpr double kElasticShare = 1e-3;

}  // namespace of_newton

/// Of line searches.
namespace of_line_search {

// Of what an increment promises, the fall that is asked for; and how often it is halved, 1/256 being no way forward.
inline constexpr double kLeastFall = 0.1;
inline constexpr int kMostHalvings = 8;
// Shares of the change of the round before: above the first a round does not lead on, below the second it leads far; of
// its part p it promises p, and the third of that is enough. The least part that is taken.
inline constexpr double kStalls = 0.7;
inline constexpr double kLeads = 0.25;
inline constexpr double kPromised = 0.9;
inline constexpr double kLeastPart = 1.0 / 16;

}  // namespace of_line_search

/// Of the smooth motion of a step, whose rounds end by what they change.
namespace of_smooth_motion {

// Increments that change by less than this share of block size are settled: a hundred times round-off of a position.
inline constexpr double kSettled = 1e-12;
// Usually one to three rounds. A change below kTolerable after the last round is accepted, and the next step closes the
// gap error that it leaves. A larger change is a failure, unless the forces fit the gaps of the last round: a light
// block moves far by what is nothing to a heavy one.
inline constexpr int kMostRounds = 8;
inline constexpr int kMostRoundsOfSprings = 30;  // whose law is not linear where they meet or part
inline constexpr int kMostRoundsOfYield = 40;    // points change sides of their surface from round to round
// Rock that yields is stiff for its strength: a change of strain of this size is a ten-thousandth of the strength where
// that is a hundred-thousandth of the modulus.
inline constexpr double kTolerableOfYield = 1e-9;
inline constexpr double kTolerable = 1e-6;
// Rounds of tolerable changes that new tangents made no less: of round-off every second is one.
inline constexpr int kStallsOfRoundOff = 3;
// Rows and matrix are made anew about the first estimates, and where these moved by more than the second figure:
// directions of forces are then as good as that, and gaps are those of the estimate itself in any case.
inline constexpr int kMostRows = 2;
inline constexpr double kSameRows = 1e-9;
// Of few pairs they cost next to nothing: forces then do their work along the way of the step to the last digits.
inline constexpr double kSameRowsOfFew = kSettled;
// In assemblies rows may be as wrong as forces are, and forces that meet the gaps of the last estimate within this many
// times their goal, a hundred-thousandth of the heaviest load, are not sought again: what is left is a share of that
// size of the free fall of a step.
inline constexpr double kSameRowsOfMany = 1e-5;
inline constexpr double kGoalsOfEstimate = 10;
inline constexpr double kOfLast = 2;
// The matrix of bodies on covers is kept from round to round while a round leaves less than this share of the change
// before.
inline constexpr double kWorstGain = 0.03;
// A tangent about increments that differ by less is the same one: where elements are a thousandth of a body it differs
// by a share of that, far less than the gain that is asked for. What it costs is a solution a contact force.
inline constexpr double kSameTangent = 1e-6;

}  // namespace of_smooth_motion

/// Of a step in time: its cuts, and what contact forces are solved to.
namespace of_steps {

inline constexpr int kMostHalvings = 2;
inline constexpr int kMostHalvingsOfYield = 5;  // flow that finds no balance in a long step finds it in a short one
// Impacts of few touches at which a step is parted; those that follow are struck as at its end. A part ends this share
// of the step after the impact, so that it is sure to lie within, and no part is shorter.
inline constexpr int kMostImpacts = 4;
inline constexpr double kInstant = 1e-3;
// Each search adds the corners that the last solution made overlap; what is left after these is for the next step.
inline constexpr int kMostSearches = 4;
// Residual of the contact forces over the largest load on a block: few contacts reach the first, assemblies the second.
inline constexpr double kForceGoal = 1e-10;
inline constexpr double kForceAcceptable = 1e-6;
// In assemblies of more touches than `kFewPairs` the first is a setting, a millionth, far below what a step does to
// forces; and a ten-thousandth, judged by what one force does to its own blocks in the step, is a gap of that share of
// their free fall, and what a run is trusted with.
inline constexpr double kForceAcceptableOfMany = 1e-4;
// In the shortest part of a cut step a few pairs among many may go on changing sides: a hundredth is taken, or what
// changes the largest momentum by a ten-thousandth, and the pairs are told.
inline constexpr double kForceToleratedOfMany = 1e-2;
inline constexpr double kMomentumToleratedOfMany = 1e-4;
// A force below this is round-off of gaps in a short step.
inline constexpr double kLeastForceOfMany = 1e-8;
// Where nothing loads the blocks, forces come from momentum alone: the same over momentum / dt.
inline constexpr double kMomentumGoal = 1e-13;
inline constexpr double kMomentumAcceptable = 1e-9;

}  // namespace of_steps

/// Of contact forces without impacts.
namespace of_gaps {

// Gaps below this share of block size count as closed, and bodies so near touch: far above the rounding of files, far
// below what the eye sees.
inline constexpr double kTouching = 1e-6;
// Gaps of this share of block size need not be closed further by forces without springs.
inline constexpr double kGapTolerance = 1e-9;
// Where nothing loads a scene, no load says what forces are small: round-off is these shares of what the gaps ask for
// one by one.
inline constexpr double kRoundOff = 1e-14;
inline constexpr double kFewRoundOffs = 1e-12;
// A bond that opens by more than this share of block size in a step is broken; less is round-off of the solution.
inline constexpr double kBroken = 1e-11;

}  // namespace of_gaps

/// Of jumps, and of overlaps that are removed.
namespace of_impacts {

// Overlap of this share of block size is round-off of a position; linearised passes get there in two or three. In
// assemblies what is left is far below what the next step pushes out by itself.
inline constexpr double kNoOverlap = 1e-14;
inline constexpr double kNoOverlapOfMany = 5e-11;
inline constexpr int kMostPasses = 10;
// Some overlaps cannot all be removed at once. To find them, the pushes are solved once with every contact softened by
// kYield of what its blocks yield, so that there always is a solution: a contact that keeps more than kLocked of its
// overlap is locked. A pair with room keeps a hundredth, a chain of ten a tenth.
inline constexpr double kYield = 1e-2;
inline constexpr double kLocked = 0.1;
// In assemblies such soft pushes are all there are: each is settled to this share of the greatest overlap.
inline constexpr double kPushed = 1e-3;
inline constexpr double kLeftToStep = 1e-7;  // of block size, which the next step pushes out by itself
inline constexpr double kWorse = 1.1;
inline constexpr int kMostSoftPasses = 5;
// Among very many touches an impact moves all blocks that hang together by what its impulses are uncertain: pushed out
// in two passes but for this. Deep overlaps, of blocks that fly into each other, lie far apart and are pushed out as
// they are.
inline constexpr int kSoftPassesOfVeryMany = 2;
inline constexpr double kLeftLate = 1e-4;  // of block size
inline constexpr double kDeep = 1e-3;      // of block size
// What yields so leaves a ten-thousandth of a push to the neighbours of the neighbours of the blocks that overlap.
inline constexpr int kRings = 3;
// Impulses are settled at this share of the largest momentum; a residual this much larger still counts where redundant
// ones keep it out of reach.
inline constexpr double kImpulseTolerance = 1e-13;
inline constexpr double kLooser = 1e4;
// In assemblies they are settled as well as forces are: to a millionth of the largest momentum or, where that is more,
// a hundredth of the largest impulse that one impact alone would make. A pair that still approaches at this share of
// what counts as slow is left to the next step.
inline constexpr double kImpulseToleranceOfMany = 1e-6;
inline constexpr double kShareOfImpulse = 1e-2;
inline constexpr double kShareOfSlow = 1e-2;
// Friction of what makes velocities vanish is taken from the round before: each leaves a share of friction times
// slenderness.
inline constexpr int kMostFrictionRounds = 5;
inline constexpr double kSmallest = 1e-300;  // a tolerance is never zero

}  // namespace of_impacts

/// Of the size of steps under step control.
namespace of_step_control {

inline constexpr double kSafety = 0.9;
// The error goes with the third power of the part in smooth motion, with the first where an impact lies in it.
inline constexpr double kOrder = 2;
inline constexpr double kMostGrowth = 2;
inline constexpr double kMostCut = 0.1;
inline constexpr double kUnsolvedCut = 0.25;  // where contact forces do not settle
inline constexpr double kGreatestRatio = 3;   // over the allowed displacement, as in the steps of the old program
inline constexpr double kEnd = 1e-9;          // what is left of an interval below this share of it is round-off

}  // namespace of_step_control

/// Of accelerations that fit held contacts.
namespace of_accelerations {

// A tangential force nearer than this share to the friction limit belongs to a slip.
inline constexpr double kAtLimit = 1e-9;
// Residual over the largest force; redundant touches may keep it out of reach, then a residual this much larger counts.
inline constexpr double kTolerance = 1e-13;
inline constexpr double kLooser = 1e4;
inline constexpr double kSmallest = 1e-300;  // a tolerance is never zero

}  // namespace of_accelerations

/// What counts as at rest.
namespace of_rest {

// Of the largest load: a hundred times what contact forces are solved to.
inline constexpr double kBalanced = 1e-8;
// Way of a held point from where it is wanted, over the size of its block: above what steps settle increments to.
inline constexpr double kInPlace = 1e-9;

}  // namespace of_rest

/// Of the forces of a compatible start.
namespace of_start_forces {

inline constexpr double kForceTolerance = 1e-12;  // of the largest force on a block
inline constexpr double kLooser = 1e6;            // what counts as solved where the goal is out of reach
inline constexpr double kUnbalanced = 1e-6;       // of the greatest acceleration by the loads

// Contact stiffness over the inertia that keeps rigid motion finite while forces are distributed.
inline constexpr double kLong = 1e3;
// Weight of the proximal term over the flexibility of a touch, much less than the share of it that is elastic.
inline constexpr double kRegular = 1e-7;
// Slip given to a sliding touch, over all others, so that it slides on.
inline constexpr double kBeyond = 1e3;
// A friction force this near to its limit slides.
inline constexpr double kSliding = 1 - 1e-6;

}  // namespace of_start_forces

/// Of the shifts of a compatible start.
namespace of_compatible_start {

// Three rounds suffice where statics gives the forces; then elasticity does, and each shrinks the misfit several times.
inline constexpr int kStaticRounds = 3;
inline constexpr int kMostRounds = 20;
inline constexpr double kRoundOff = 1e-9;  // share of block size, or of acceleration, that the rounding of files leaves
inline constexpr double kFits = 1e-9;      // misfit over the gaps that were to be closed
inline constexpr double kShiftTolerance = 1e-13;  // of the gaps to be closed
// A block that shifts by more than this times all gaps together is thrown about, not settled.
inline constexpr double kLeverage = 10;

}  // namespace of_compatible_start

/// Of a start that is settled.
namespace of_settled_start {

// Stiffness of the contacts over what keeps parts that nothing holds from being free, as a share of their mass: the
// slowest mode of a mass a thousand blocks high has a millionth of the stiffness of a contact, and should not feel it.
inline constexpr double kHeldByNothing = 1e10;
// Compliance of held points over that of a contact.
inline constexpr double kRigid = 1e-4;
// Stiffness of the contacts over the inertia of the heaviest block in steps that dissolve the glue: a free block moves
// by half that times its weight over the contact stiffness in each. It grows from step to step while nothing moves
// farther than a share of block size: what the glue bore across many blocks finds its way in long steps only.
inline constexpr double kShortest = 16;
inline constexpr double kLongest = 4096;
inline constexpr double kGrowth = 4;
inline constexpr double kFarthest = 1e-5;
inline constexpr int kMostSteps = 40;
inline constexpr int kMostSearches = 4;
// Where a step moves this many times the last one's share of what a free block does, friction bears in more ways than
// one, and a long step may find another than the one it came along: it is made again so much shorter.
inline constexpr double kRises = 2;
inline constexpr double kShorter = 16;
// At rest is what moves by less than this share of what a free block does.
inline constexpr double kAtRest = 1e-4;
// Two steps are equally long if their ways differ by less than this share: the scene moves on under settled forces.
inline constexpr double kEvenly = 1e-3;
// Residual of the start, a share of the largest load on a block. All steps of the run inherit it. The second value is
// accepted where the solver reaches no less: wedged blocks under multipliers may have many solutions.
inline constexpr double kForceTolerance = 1e-6;
inline constexpr double kForceTolerated = 1e-3;

}  // namespace of_settled_start

/// Of a start at rest, found as any state at rest is.
namespace of_resting_start {

// Iterations of one search. Those that find a rest take tens; what slides or falls has gone its own size by then.
inline constexpr int kMostIterations = 300;
inline constexpr int kMostSearches = 5;  // each leaves out what the one before named
// Way of a vertex over block size up to which a body is where it was drawn; and where stress of the file, which no
// share of the loads makes smaller, lets nothing else be said.
inline constexpr double kInPlace = 1e-3;
inline constexpr double kInPlaceStressed = 1e-2;
// Beyond it a body that deforms goes a share of the way under that share of the loads, one that swings or slides to
// another place all of it.
inline constexpr double kSmallShare = 0.1;
inline constexpr double kSameWay = 0.5;

}  // namespace of_resting_start

/// Of the proximal point iteration for a state at rest, whose parts are steps of pseudo time.
namespace of_statics {

// Residual of the contact forces over the largest load, to reach and to be content with at the end; on the way a share
// of what is out of balance does, as for any inexact proximal point.
inline constexpr double kForceGoal = 1e-10;
inline constexpr double kForceAcceptable = 1e-9;
inline constexpr double kForceOnTheWay = 1e-6;
// Way of a vertex in one iteration over block size: gaps and loads are taken as linear in it.
inline constexpr double kFarthest = 0.05;
inline constexpr double kAimed = 0.5;  // share of it that τ is chosen for
inline constexpr double kGrowth = 4;
inline constexpr double kGrowthAfterCut = 1.2;  // once contact forces did not settle under a longer τ
// Longest τ times the slowest frequency of a block: what is left of an elastic error after one iteration is its square
// inverse, where blocks bend as a whole more by as much as that is slower.
inline constexpr double kLongest = 3e3;
// Where a body does not strain, forces are judged by its rigid motion, and a longer τ would let springs and gaps go
// unjudged.
inline constexpr double kLongestOfRigid = 30;
// Loads that follow the rotation are not linearised, so too large a τ makes a hanging block overshoot its rest
// position, further in each iteration. Where blocks turn back and more is out of balance than before, τ stays below
// this share of the one that caused it.
inline constexpr double kAfterRise = 0.5;
inline constexpr double kRaised = 1.2;  // in each iteration without such a turn
inline constexpr int kLook = 10;        // iterations between two looks at what is out of balance
inline constexpr double kFalls = 0.5;
inline constexpr double kLonger = 2;
// Forces out of balance are steady if they change by less than kSame. After kSteady such iterations a block that has
// moved by kFarIfSteady of its size accelerates; it moved so little because contact forces settled under short τ alone.
inline constexpr double kSame = 1e-3;
inline constexpr int kSteady = 50;
inline constexpr double kFarIfSteady = 1e-2;
inline constexpr double kBalanceAcceptable = 1e-6;  // where no more can be had
inline constexpr int kMostIterations = 2000;
inline constexpr double kBalancedToBegin = 1e-8;  // where it is found as a rule, for what is told of the way
inline constexpr int kMostCuts = 20;              // one after another
inline constexpr int kMostSearches = 4;           // each adds corners that the last solution made overlap
// Touches nearer than this share of block size at the start of slip counting were closed then.
inline constexpr double kClosedThen = 1e-6;

}  // namespace of_statics

}  // namespace keyblock::tolerances
