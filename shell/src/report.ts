import type { Direction, SurfaceState } from './bridge';
import type { Parameter } from './knotwork';
import { say } from './words';

/// The report's table: what opening and closing makes of the counts. The row of the present topology is the module's
/// own; the others follow from its numbers of local surfaces (THEORY 2.8).

type Topology = 'open' | 'closed';

/// One direction of one row: what a cell shows.
export interface Counts {
  topology: Topology;
  domain: string;
  knots: number;
  patches: number;
  locals: number;
}

export interface Row {
  u: Counts;
  v: Counts;
  shape: string;
  current: boolean;
  /// Why the model cannot have this row's topology; '' when it can.
  refused: string;
}

export function direction(letter: 'u' | 'v', topology: Topology, locals: number): Counts {
  const closed = topology === 'closed';
  const last = subscript(closed ? locals + 1 : locals);
  return {
    topology,
    domain: `[${letter}₁, ${letter}${last}${closed ? ')' : ']'}`,
    knots: locals + (closed ? 3 : 2),
    patches: closed ? locals : locals - 1,
    locals,
  };
}

export function rows(state: SurfaceState, table: ReadonlyMap<string, Parameter>): Row[] {
  const refusal = (id: string, topology: Topology): string =>
    table.get(id)?.choices.find((choice) => choice.id === topology)?.refused ?? '';
  // Only the sheet takes another shape with another topology.
  const fixed = table.get('model')?.value !== 'sheet';
  const pairs: [Topology, Topology][] = [['open', 'open'], ['open', 'closed'], ['closed', 'open'], ['closed', 'closed']];
  return pairs.map(([u, v]) => {
    const current = state.u.topology === u && state.v.topology === v;
    const closed = Number(u === 'closed') + Number(v === 'closed');
    return {
      u: current ? countsOf(state.u) : direction('u', u, state.u.locals),
      v: current ? countsOf(state.v) : direction('v', v, state.v.locals),
      shape: current || fixed ? state.shape : ['plane', 'cylinder', 'torus'][closed]!,
      current,
      refused: refusal('topology.u', u) || refusal('topology.v', v),
    };
  });
}

function countsOf({ topology, domain, knots, patches, locals }: Direction): Counts {
  return { topology, domain, knots: knots.length, patches, locals };
}

export function subscript(number: number): string {
  return String(number).replace(/\d/g, (digit) => String.fromCharCode(0x2080 + Number(digit)));
}

/// Fills `place` with the table once, and again with new numbers; phrases in it set both topologies.
export class ReportTable {
  private readonly cells: HTMLElement[][] = [];
  private readonly rowElements: HTMLTableRowElement[] = [];
  private readonly buttons: HTMLButtonElement[] = [];
  private readonly shapes: HTMLElement[] = [];

  constructor(place: HTMLElement, setTopologies: (u: Topology, v: Topology) => void) {
    const table = document.createElement('table');
    table.innerHTML =
      `<caption class="hidden">${say('What opening and closing does to the counts')}</caption><thead><tr>` +
      ['u, v', 'domain', 'knots', 'patches', 'local patches', 'shape']
        .map((heading) => `<th scope="col">${say(heading)}</th>`)
        .join('') +
      '</tr></thead>';
    const body = table.createTBody();
    for (let i = 0; i < 4; ++i) {
      const row = body.insertRow();
      this.rowElements.push(row);
      const heading = document.createElement('th');
      heading.scope = 'row';
      const button = document.createElement('button');
      button.type = 'button';
      button.className = 'act';
      const u: Topology = i < 2 ? 'open' : 'closed';
      const v: Topology = i % 2 === 0 ? 'open' : 'closed';
      button.textContent = `${say(u)}, ${say(v)}`;
      button.addEventListener('click', () => setTopologies(u, v));
      this.buttons.push(button);
      heading.append(button);
      row.append(heading);
      this.cells.push(Array.from({ length: 4 }, () => pairCell(row)));
      this.shapes.push(row.insertCell());
    }
    place.replaceChildren(table);
  }

  update(state: SurfaceState, table: ReadonlyMap<string, Parameter>): void {
    rows(state, table).forEach((row, i) => {
      const element = this.rowElements[i]!;
      if (row.current) element.setAttribute('aria-current', 'true');
      else element.removeAttribute('aria-current');
      const [domain, knots, patches, locals] = this.cells[i]!;
      fill(domain!, row.u.domain, row.v.domain);
      fill(knots!, row.u.knots, row.v.knots);
      fill(patches!, row.u.patches, row.v.patches);
      fill(locals!, row.u.locals, row.v.locals);
      const shape = row.refused ? '–' : say(row.shape);
      if (this.shapes[i]!.textContent !== shape) this.shapes[i]!.textContent = shape;
      const button = this.buttons[i]!;
      button.setAttribute('aria-disabled', String(row.refused !== ''));
      button.title = row.refused;
    });
  }
}

/// "a × b"; a narrow table has the one above the other instead, without the cross.
function pairCell(row: HTMLTableRowElement): HTMLElement {
  const cell = row.insertCell();
  cell.className = 'pair';
  cell.innerHTML = '<span></span><i> × </i><span></span>';
  return cell;
}

function fill(cell: HTMLElement, u: string | number, v: string | number): void {
  const [first, second] = cell.querySelectorAll('span');
  if (first!.textContent !== `${u}`) first!.textContent = `${u}`;
  if (second!.textContent !== `${v}`) second!.textContent = `${v}`;
}
