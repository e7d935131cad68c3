// Text of a case, JSON or YAML: reads it with the place of every value, and changes one value at its place.

import * as json from './json_text';
import * as yaml from './yaml_text';

export { find, JsonError, line_of, type Node, type Path, plain, type Step, tidy, type Value } from './json_text';

const of = (text: string) => (yaml.is_yaml(text) ? yaml : json);

export const parse = (text: string): json.Node => of(text).parse(text);

export const set = (text: string, path: json.Path, value: json.Value): string => of(text).set(text, path, value);

export const splice = (text: string, path: json.Path, index: number, count: number, values: json.Value[]): string =>
  of(text).splice(text, path, index, count, values);

export const remove = (text: string, path: json.Path): string => of(text).remove(text, path);
