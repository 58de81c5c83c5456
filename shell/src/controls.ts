import type { Parameter } from './knotwork';

/// HTML controls made from rows of the parameter table: native elements with labels, kept in step with the module.

export interface Control {
  readonly id: string;
  update(parameter: Parameter): void;
}

export type SetValue = (id: string, value: number | string | boolean) => void;

let serial = 0;

/// Fills `place` with the control that suits `parameter`.
export function makeControl(place: HTMLElement, parameter: Parameter, set: SetValue): Control {
  if (parameter.kind === 'toggle') return makeSwitch(place, parameter, set);
  if (parameter.kind !== 'choice') return makeRange(place, parameter, set);
  return parameter.choices.length <= 3 ? makeSegments(place, parameter, set) : makeSelect(place, parameter, set);
}

function makeSegments(row: HTMLElement, parameter: Parameter, set: SetValue): Control {
  // The row becomes a fieldset: the group's name is its legend.
  const place = document.createElement('fieldset');
  place.className = row.className;
  place.dataset['parameter'] = parameter.id;
  place.dataset['kind'] = 'segments';
  row.replaceWith(place);
  const legend = element('legend', '');
  if (parameter.label.length <= 2) legend.append(element('span', 'hidden', `${parameter.group} `));
  legend.append(parameter.label);
  const segments = element('div', 'segments');
  const reason = reasonFor(place, true);
  const name = `parameter-${++serial}`;
  const inputs = new Map<string, HTMLInputElement>();
  for (const choice of parameter.choices) {
    const label = element('label', '');
    const input = element('input', '');
    input.type = 'radio';
    input.name = name;
    input.value = choice.id;
    input.addEventListener('change', () => set(parameter.id, choice.id));
    label.append(input, choice.label);
    segments.append(label);
    inputs.set(choice.id, input);
  }
  place.replaceChildren(legend, segments, reason.element);
  return {
    id: parameter.id,
    update(now) {
      const reasons = new Set<string>();
      for (const choice of now.choices) {
        const input = inputs.get(choice.id);
        if (!input) continue;
        input.checked = now.value === choice.id;
        const why = now.disabled || choice.refused;
        input.disabled = why !== '' && !input.checked;
        reason.describe(input, input.disabled);
        if (input.disabled) reasons.add(why);
      }
      reason.say([...reasons].join(' '));
    },
  };
}

function makeSelect(place: HTMLElement, parameter: Parameter, set: SetValue): Control {
  const select = element('select', '');
  const label = labelFor(select, parameter.label);
  const reason = reasonFor(place);
  for (const choice of parameter.choices) select.add(new Option(choice.label, choice.id));
  select.addEventListener('change', () => set(parameter.id, select.value));
  const frame = element('div', 'choose');
  frame.append(select);
  place.dataset['kind'] = 'select';
  place.replaceChildren(label, frame, reason.element);
  return {
    id: parameter.id,
    update(now) {
      select.value = String(now.value);
      select.disabled = now.disabled !== '';
      now.choices.forEach((choice, i) => {
        const option = select.options[i];
        if (option) option.disabled = choice.refused !== '';
      });
      reason.describe(select, now.disabled !== '');
      reason.say(now.disabled);
      place.classList.toggle('off', now.disabled !== '');
    },
  };
}

function makeRange(place: HTMLElement, parameter: Parameter, set: SetValue): Control {
  const input = element('input', '');
  input.type = 'range';
  const label = labelFor(input, parameter.label);
  const output = element('output', '');
  output.htmlFor.add(input.id);
  const reason = reasonFor(place);
  input.addEventListener('input', () => set(parameter.id, input.valueAsNumber));
  place.replaceChildren(label, input, output, reason.element);
  return {
    id: parameter.id,
    update(now) {
      const value = Number(now.value);
      input.min = String(now.min);
      input.max = String(now.max);
      input.step = now.step > 0 ? String(now.step) : 'any';
      input.value = String(value);
      const share = now.max > now.min ? (value - now.min) / (now.max - now.min) : 0;
      input.style.setProperty('--share', `${100 * Math.min(1, Math.max(0, share))}%`);
      const text = format(now);
      if (output.value !== text) output.value = text;
      input.setAttribute('aria-valuetext', text);
      input.disabled = now.disabled !== '';
      reason.describe(input, input.disabled);
      reason.say(now.disabled);
      place.classList.toggle('off', input.disabled);
    },
  };
}

function makeSwitch(place: HTMLElement, parameter: Parameter, set: SetValue): Control {
  const button = element('button', 'switch', parameter.label);
  button.type = 'button';
  button.setAttribute('role', 'switch');
  const reason = reasonFor(place);
  button.addEventListener('click', () => set(parameter.id, button.getAttribute('aria-checked') !== 'true'));
  place.replaceChildren(button, reason.element);
  return {
    id: parameter.id,
    update(now) {
      button.setAttribute('aria-checked', String(now.value === true));
      button.disabled = now.disabled !== '';
      reason.describe(button, button.disabled);
      reason.say(now.disabled);
    },
  };
}

/// The number with its unit, as many decimals as its step has.
export function format(parameter: Pick<Parameter, 'value' | 'step' | 'unit' | 'kind'>): string {
  const decimals = parameter.kind === 'integer' ? 0 : decimalsOf(parameter.step);
  const number = Number(parameter.value).toFixed(decimals).replace('-', '−');
  return parameter.unit ? `${number}\u00a0${parameter.unit}` : number;
}

export function decimalsOf(step: number): number {
  if (!(step > 0)) return 2;
  let decimals = 0;
  while (decimals < 6 && Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-9) ++decimals;
  return decimals;
}

function labelFor(input: HTMLElement, text: string): HTMLLabelElement {
  input.id ||= `control-${++serial}`;
  const label = element('label', 'label', text);
  label.htmlFor = input.id;
  return label;
}

/// A line that says why a control is off, tied to it for screen readers. Where it is not `seen` the control's dimness
/// and its tooltip say enough, and the row keeps its height.
function reasonFor(place: HTMLElement, seen = false) {
  const line = element('p', seen ? 'reason' : 'hidden');
  line.id = `reason-${++serial}`;
  line.hidden = true;
  return {
    element: line,
    describe(input: HTMLElement, off: boolean) {
      if (off) input.setAttribute('aria-describedby', line.id);
      else input.removeAttribute('aria-describedby');
    },
    say(text: string) {
      if (line.textContent === text) return;
      line.textContent = text;
      line.hidden = text === '';
      place.title = seen ? '' : text;
    },
  };
}

export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  className: string,
  text?: string,
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text !== undefined) made.textContent = text;
  return made;
}
