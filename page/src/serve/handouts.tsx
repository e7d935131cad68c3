// Links to files about a result that can be mailed.

import * as api from './api';
import { leaf_of } from './cases';

/** Files about a result to mail: the page of a run, and the report for clients. */
export function Handouts({ path, has_page = true }: { path: string; has_page?: boolean }) {
  return (
    <>
      {has_page && (
        <a class="button" download={`${leaf_of(path)}.html`} href={api.address('/page', { result: path })}>
          Save the page
        </a>
      )}
      <a class="button" download={`${leaf_of(path)}_report.html`} href={api.address('/report', { result: path })}>
        Save a report
      </a>
    </>
  );
}
