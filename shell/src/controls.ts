import type { Parameter } from './knotwork';
import { say } from './words';

/// HTML controls made from rows of the parameter table: native elements with labels, kept in step with the module.

export interface Control {
  readonly id: string;
  update(parameter: Parameter): void;
  /// What is on the stage has no such parameter.
  rest(): void;
}

export interface Setter {
  set(id: string, value: number | string | boolean): void;
  /// What is set while a gesture is open is one step of undo.
  gesture(open: boolean): void;
}

let serial = 0;

/// Fills `place` with the control that suits `parameter`.
export function makeControl(place: HTMLElement, parameter: Parameter, setter: Setter): Control {
  const control = controlFor(place, parameter, setter);
  let last = parameter;
  return {
    id: parameter.id,
    update: (now) => control.update((last = now)),
    rest: () => control.update({ ...last, disabled: say('The stage shows something else.') }),
  };
}

type Updated = Omit<Control, 'rest'>;

function controlFor(place: HTMLElement, parameter: Parameter, setter: Setter): Updated {
  if (parameter.kind === 'toggle') return makeSwitch(place, parameter, setter);
  if (parameter.kind !== 'choice') return makeRange(place, parameter, setter);
  return parameter.choices.length <= 3 ? makeSegments(place, parameter, setter) : makeSelect(place, parameter, setter);
}

function makeSegments(place: HTMLElement, parameter: Parameter, setter: Setter): Updated {
  place.dataset['kind'] = 'segments';
  const label = element('span', 'label');
  label.id = `label-${++serial}`;
  // A single letter says too little to a reader who does not see what stands around it.
  if (parameter.label.length <= 2) {
    label.append(element('span', 'hidden', `${parameter.group} `));
    place.classList.add('short');
  }
  label.append(parameter.label);
  const segments = element('div', 'segments');
  segments.setAttribute('role', 'group');
  segments.setAttribute('aria-labelledby', label.id);
  const reason = reasonFor(place, true);
  const name = `parameter-${++serial}`;
  const inputs = new Map<string, HTMLInputElement>();
  for (const choice of parameter.choices) {
    const item = element('label', '');
    const input = element('input', '');
    input.type = 'radio';
    input.name = name;
    input.value = choice.id;
    input.addEventListener('change', () => setter.set(parameter.id, choice.id));
    item.append(input, choice.label);
    segments.append(item);
    inputs.set(choice.id, input);
  }
  place.replaceChildren(label, segments, reason.element);
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

function makeSelect(place: HTMLElement, parameter: Parameter, setter: Setter): Updated {
  const select = element('select', '');
  const label = labelFor(select, parameter.label);
  const reason = reasonFor(place);
  for (const choice of parameter.choices) select.add(new Option(choice.label, choice.id));
  select.addEventListener('change', () => setter.set(parameter.id, select.value));
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

function makeRange(place: HTMLElement, parameter: Parameter, setter: Setter): Updated {
  const input = element('input', '');
  input.type = 'range';
  const label = labelFor(input, parameter.label);
  const output = element('output', '');
  output.htmlFor.add(input.id);
  const reason = reasonFor(place);
  let dragging = false;
  input.addEventListener('input', () => {
    const value = input.valueAsNumber;  // before the gesture brings the control up to date
    if (!dragging) setter.gesture((dragging = true));
    setter.set(parameter.id, value);
  });
  // A drag that ends where it began fires no `change`.
  for (const end of ['change', 'pointerup', 'pointercancel', 'keyup', 'blur'])
    input.addEventListener(end, () => {
      if (dragging) setter.gesture((dragging = false));
    });
  place.replaceChildren(label, input, output, reason.element);
  return {
    id: parameter.id,
    update(now) {
      const value = Number(now.value);
      const min = Math.min(now.softMin ?? now.min ?? 0, value);
      const max = Math.max(now.softMax ?? now.max ?? 1, value);
      input.min = String(min);
      input.max = String(max);
      input.step = now.step ? String(now.step) : 'any';
      input.value = String(value);
      const share = max > min ? (value - min) / (max - min) : 0;
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

function makeSwitch(place: HTMLElement, parameter: Parameter, setter: Setter): Updated {
  const button = element('button', 'switch', parameter.label);
  button.type = 'button';
  button.setAttribute('role', 'switch');
  const reason = reasonFor(place);
  button.addEventListener('click', () => setter.set(parameter.id, button.getAttribute('aria-checked') !== 'true'));
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

export function decimalsOf(step: number | null): number {
  if (!step) return 2;
  let decimals = 0;
  const whole = (x: number): boolean => Math.abs(x - Math.round(x)) <= 1e-6 * x;
  while (decimals < 6 && !whole(step * 10 ** decimals)) ++decimals;
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
