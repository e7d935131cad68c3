// Result of a search for the factor of safety: factor, bracket, trials.

import { useEffect, useState } from 'preact/hooks';
import { show } from '../draw/numbers';
import { sentence } from '../draw/words';
import * as api from './api';
import { Handouts } from './handouts';
import * as state from './state';
import { bracket_words, factor_words, type StrengthResult } from './verdicts';

interface Trial {
  factor: number;
  verdict: string;
  largest_displacement?: number | null;
  why?: string;
}

interface Strength extends StrengthResult {
  case?: string;
  profile?: string;
  notes?: string[];
  trials?: Trial[];
  units?: { length?: string };
}

const VERDICTS: Record<string, string> = { stands: 'stable', falls: 'unstable' };

export function StrengthView({ path }: { path: string }) {
  const [record, set_record] = useState<Strength | null>(null);
  useEffect(() => {
    let is_old = false;
    void state
      .attempt(() => api.record(path))
      .then(own => {
        if (own && !is_old) set_record(own as Strength);
      });
    return () => {
      is_old = true;
    };
  }, [path]);
  if (!record) return <p class="note pad">Reading the record…</p>;
  const [heading, factor] = factor_words(record);
  const bracket = bracket_words(record);
  const unit = record.units?.length ?? '';
  const trials = (record.trials ?? []).slice().sort((a, b) => a.factor - b.factor);
  return (
    <div class="strength">
      <div class="bar">
        <h2>{path}</h2>
        <span class="space" />
        <Handouts path={path} has_page={false} />
      </div>
      <p class="factor">
        {heading} {factor && <b>{factor}</b>}
      </p>
      {bracket && <p>{bracket}</p>}
      {(record.notes ?? []).map(text => (
        <p class="note" key={text}>
          {sentence(text)}
        </p>
      ))}
      <img
        class="picture"
        alt={`Model of ${path} at both ends of the bracket`}
        src={api.address('/api/picture', { result: path })}
        onError={event => {
          event.currentTarget.hidden = true;
        }}
      />
      <table class="list">
        <caption>Trials</caption>
        <thead>
          <tr>
            <th scope="col" class="number">
              Factor
            </th>
            <th scope="col">Model</th>
            <th scope="col" class="number">
              Largest displacement{unit && ` [${unit}]`}
            </th>
          </tr>
        </thead>
        <tbody>
          {trials.map(own => (
            <tr key={own.factor}>
              <td class="number">{show(own.factor, 5)}</td>
              <td>
                {VERDICTS[own.verdict] ?? own.verdict}
                {own.why && <span class="note"> ({own.why})</span>}
              </td>
              <td class="number">{show(own.largest_displacement, 3)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
