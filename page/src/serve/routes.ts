// Addresses within the window, after the #.

export type Route =
  | { kind: 'home' }
  | { kind: 'new' }
  | { kind: 'case'; paths: string[] }
  | { kind: 'result'; path: string }
  | { kind: 'compare'; first: string; second: string }
  | { kind: 'study'; study: string; paths: string[] };

export function route_of(hash: string): Route {
  const [, kind, ...rest] = hash.split('/');
  let parts: string[];
  try {
    parts = rest.map(decodeURIComponent);
  } catch {
    return { kind: 'home' };
  }
  if (kind === 'new') return { kind };
  if (kind === 'case' && parts.length) return { kind, paths: parts };
  if (kind === 'result' && parts[0]) return { kind, path: parts[0] };
  if (kind === 'compare' && parts.length === 2) return { kind, first: parts[0], second: parts[1] };
  if (kind === 'study' && parts.length > 1) return { kind, study: parts[0], paths: parts.slice(1) };
  return { kind: 'home' };
}

export function link(kind: string, ...parts: string[]): string {
  return `#/${kind}/${parts.map(encodeURIComponent).join('/')}`;
}
