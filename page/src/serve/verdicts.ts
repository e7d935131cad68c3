// Words on results, as command line and reports have them.

import { show } from '../draw/numbers';

/** Record of a search for the factor of safety, as far as its result goes. */
export interface StrengthResult {
  reduced?: string;
  /** End of the search: bracketed, falls, stands, undecided or stopped. */
  end?: string;
  factor_of_safety?: number | null;
  /** The factor of safety may be larger. */
  lower_estimate?: boolean;
  bracket?: { stands?: number | null; falls?: number | null };
}

const REDUCED: Record<string, string> = { joints: 'joints', rock: 'rock', both: 'joints and rock' };

/** Factor of safety with its reservation, or why there is none: heading and figure. */
export function factor_words({ factor_of_safety, lower_estimate, end }: StrengthResult): [string, string] {
  if (typeof factor_of_safety === 'number')
    return ['Factor of safety', `${show(factor_of_safety, 4)}${lower_estimate ? ' (a lower estimate)' : ''}`];
  return [
    end === 'stopped' ? 'The search was stopped before it found a factor of safety.' : 'No factor of safety was found.',
    '',
  ];
}

/** Sentence on the factors at which the model is stable and unstable; empty without any. */
export function bracket_words({ bracket, reduced }: StrengthResult): string {
  const known = [
    typeof bracket?.stands === 'number' ? `stable at ${bracket.stands.toPrecision(4)}` : '',
    typeof bracket?.falls === 'number' ? `unstable at ${bracket.falls.toPrecision(4)}` : '',
  ].filter(Boolean);
  if (!known.length) return '';
  const strength = REDUCED[reduced ?? ''] ?? reduced;
  return `The model is ${known.join(', ')}, with the strength of ${strength} divided by these factors.`;
}

/** Words on exit codes of the program besides 0. */
const ENDINGS: Record<number, string> = {
  1: 'finished, but a check failed',
  2: 'refused: the request is not valid',
  3: 'refused: the input cannot be read or used',
  4: 'failed: the computation could not continue, or its results could not be written',
  5: 'ended at a limit of processor time or memory; results up to there are saved',
  6: 'failed: its results could not be written',
};

/** True if a program that ended with this code left no result of its own. */
export const is_failure = (code: number | undefined): boolean => code !== 0 && code !== 1;

/** Words on the end of a job by its exit code. */
export const ending_words = (code: number | undefined): string => ENDINGS[code ?? -1] ?? `ended with code ${code}`;
