// Row of a table of facts.

export function Fact({ name, value, indent }: { name: string; value: unknown; indent?: boolean }) {
  if (value === undefined || value === null || value === '') return null;
  return (
    <tr>
      <th scope="row" class={indent ? 'indent' : undefined}>
        {name}
      </th>
      <td>{String(value)}</td>
    </tr>
  );
}
