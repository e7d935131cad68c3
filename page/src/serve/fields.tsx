// Fields of all forms of the window: a label with a box, and a box for a value that the schema describes.

import { useState } from 'preact/hooks';
import type { Value } from './edit/case_text';
import { value_of } from './edit/scene';
import { fault_in, limits_of, meaning_of, type Schema, words_of } from './edit/schema';

/** Text under a label. */
export function TextField({
  label,
  value,
  set,
  placeholder,
  title,
  list,
  is_number,
  is_small,
  is_required,
}: {
  label: string;
  value: string;
  set: (value: string) => void;
  placeholder?: string;
  title?: string;
  list?: string;
  is_number?: boolean;
  is_small?: boolean;
  is_required?: boolean;
}) {
  return (
    <label class={is_small ? undefined : 'field'} title={title}>
      <span>{label}</span>
      <input
        type="text"
        inputMode={is_number ? 'decimal' : 'text'}
        value={value}
        placeholder={placeholder}
        list={list}
        required={is_required}
        onInput={event => set(event.currentTarget.value)}
      />
    </label>
  );
}

/** One of some words under a label. */
export function ChoiceField({
  label,
  value,
  set,
  choices,
  title,
  is_small,
}: {
  label: string;
  value: string;
  set: (value: string) => void;
  choices: (string | [string, string])[];
  title?: string;
  is_small?: boolean;
}) {
  return (
    <label class={is_small ? undefined : 'field'} title={title}>
      <span>{label}</span>
      <select value={value} onChange={event => set(event.currentTarget.value)}>
        {choices.map(own => {
          const [word, words] = typeof own === 'string' ? [own, own] : own;
          return (
            <option value={word} key={word}>
              {words}
            </option>
          );
        })}
      </select>
    </label>
  );
}

/**
 * Text that counts once it is complete. What is typed stays while other parts of the window are drawn anew, and when
 * it is refused.
 */
export function TypedInput({
  id,
  label,
  value,
  take,
  placeholder,
  title,
  size,
  is_wrong,
  is_off,
}: {
  id?: string;
  /** Name for screen readers, if no label names the box. */
  label?: string;
  value: string;
  /** Takes the text without blanks around it; returns whether it is accepted. */
  take: (text: string) => boolean;
  placeholder?: string;
  title?: string;
  size?: number;
  is_wrong?: boolean;
  is_off?: boolean;
}) {
  const [typed, set_typed] = useState<string | null>(null);
  return (
    <input
      id={id}
      aria-label={label || undefined}
      type="text"
      size={size}
      value={typed ?? value}
      placeholder={placeholder}
      title={title}
      disabled={is_off}
      aria-invalid={is_wrong || undefined}
      onInput={event => set_typed(event.currentTarget.value)}
      onChange={event => {
        if (take(event.currentTarget.value.trim())) set_typed(null);
      }}
    />
  );
}

/** Meaning and limits of a value, for a box that shows neither. */
export const hint_of = (own: Schema) =>
  [meaning_of(own), limits_of(own) && `Permitted: ${limits_of(own)}.`].filter(Boolean).join(' ');

/** Box for a value: choices for words, a tick for true and false, text for all else. */
export function ValueBox({
  id,
  label,
  own,
  value,
  put,
  clear,
  placeholder,
  size,
  is_off,
}: {
  id?: string;
  /** Name for screen readers, if no label names the box. */
  label?: string;
  own: Schema;
  value: unknown;
  put: (value: Value) => void;
  clear: () => void;
  placeholder?: string;
  /** Letters of a text box. */
  size?: number;
  is_off?: boolean;
}) {
  const [fault, set_fault] = useState('');
  const types = Array.isArray(own.type) ? own.type : [own.type];
  if (own.enum)
    return (
      <select
        id={id}
        aria-label={label || undefined}
        title={hint_of(own)}
        disabled={is_off}
        value={value === undefined ? '' : String(value)}
        onChange={event => {
          const found = own.enum!.find(one => String(one) === event.currentTarget.value);
          if (found === undefined) clear();
          else put(found as Value);
        }}
      >
        {value === undefined && <option value="">{placeholder}</option>}
        {value !== undefined && !own.enum.includes(value) && <option value={String(value)}>{String(value)}</option>}
        {own.enum.map(one => (
          <option value={String(one)} key={String(one)}>
            {words_of(own, one)}
          </option>
        ))}
      </select>
    );
  if (types.includes('boolean') && types.length === 1)
    return (
      <input
        id={id}
        aria-label={label || undefined}
        type="checkbox"
        disabled={is_off}
        checked={value === true}
        onChange={event => put(event.currentTarget.checked)}
      />
    );
  return (
    <>
      <TypedInput
        id={id}
        label={label}
        value={value === undefined || typeof value === 'object' ? '' : String(value)}
        placeholder={placeholder ?? (own.default === undefined ? '' : String(own.default))}
        title={hint_of(own)}
        size={size}
        is_off={is_off}
        is_wrong={fault !== ''}
        take={typed => {
          if (!typed) {
            set_fault('');
            if (value !== undefined) clear();
            return true;
          }
          const read = types.length === 1 && types[0] === 'string' ? typed : value_of(typed);
          const wrong = fault_in(own, read);
          set_fault(wrong);
          if (!wrong && read !== value) put(read);
          return !wrong;
        }}
      />
      {fault && <span class="fault">Expected: {fault}.</span>}
    </>
  );
}
