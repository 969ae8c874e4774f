/** The control of one field: label, unit, slider, number or choice, and a way back. */
import { isNumeric, shownUnit, type Field } from '../catalogue';
import { h } from '../dom';
import type { FieldValue } from '../solver/protocol';
import { symbolOf } from '../symbols';
import { fieldMeaning, fieldName, t } from '../texts';
import { scaleOf, STEPS, type Scale } from './scale';

/** What a control does with a field. */
export interface ControlActions {
  move(field: Field, si: number): void;
  type(field: Field, text: string): void;
  reset(field: Field): void;
}

/** How a field stands. */
export interface Standing {
  value: FieldValue | undefined;
  isGiven: boolean;
  isChanged: boolean;
  problem: string | null;
}

/** The control of a field; `place` tells controls of one field apart. */
export class FieldControl {
  readonly element: HTMLElement;
  private readonly input: HTMLInputElement | HTMLSelectElement;
  private readonly slider: HTMLInputElement | null = null;
  private readonly back: HTMLButtonElement;
  private readonly remark = h('span', { class: 'default' }, t('default'));
  private readonly problem: HTMLElement;
  private scale: Scale | null = null;
  private isTyping = false;

  constructor(
    private readonly field: Field,
    private readonly actions: ControlActions,
    place = 'field',
  ) {
    const id = `${place}-${field.path.replace(/\./g, '-')}`;
    const [symbol, meaning] = explained(field);
    const unit = isNumeric(field) ? shownUnit(field)[0] : '';
    this.problem = h('p', { class: 'problem', id: `${id}-problem`, hidden: true });
    this.input = this.made(id);
    this.back = h(
      'button',
      {
        type: 'button',
        class: 'back',
        title: t('reset'),
        'aria-label': `${t('reset')}: ${field.path}`,
        onclick: () => actions.reset(field),
      },
      '↺',
    );
    const label = h('label', { for: id, title: meaning }, fieldName(field), ' ', symbolOf(symbol));
    const help = h('p', { class: 'help', id: `${id}-help` }, meaning);
    const state = h('span', { class: 'state' }, this.remark, this.back);
    const isShort = isNumeric(field);
    this.element = h('div', {
      class: isShort ? 'field short-field' : 'field',
      'data-path': field.path,
    });
    if (!isShort) {
      this.element.append(h('div', { class: 'head' }, label, state), this.input);
    } else {
      this.element.append(label, this.input, h('span', { class: 'unit' }, prettyUnit(unit)));
      this.slider = h('input', {
        type: 'range',
        min: 0,
        max: STEPS,
        step: 1,
        'aria-label': `${fieldName(field)} (${unit || '–'})`,
        oninput: () => this.slid(),
      });
      this.slider.title = meaning;
      this.element.append(this.slider, state);
    }
    this.element.append(help, this.problem);
  }

  /** Shows the state of the field. */
  show({ value, isGiven, isChanged, problem }: Standing): void {
    this.back.hidden = !isChanged;
    this.remark.hidden = isGiven || isChanged || value === undefined;
    this.problem.hidden = problem === null;
    this.problem.textContent = problem ?? '';
    this.input.setAttribute('aria-invalid', String(problem !== null));
    if (problem !== null) return;
    if (!this.isTyping) this.input.value = this.text(value);
    this.place(value);
  }

  /** Whether its name or meaning contains a text. */
  matches(text: string): boolean {
    const { field } = this;
    return [field.path, field.doc, fieldName(field), fieldMeaning(field)].some((part) =>
      part.toLowerCase().includes(text),
    );
  }

  private made(id: string): HTMLInputElement | HTMLSelectElement {
    const { field, actions } = this;
    const own = {
      id,
      'aria-describedby': `${id}-help ${id}-problem`,
      oninput: () => {
        this.isTyping = true;
      },
      onchange: () => {
        this.isTyping = false;
        actions.type(field, this.input.value);
      },
    };
    const choices =
      field.kind === 'flag'
        ? [
            ['true', ''],
            ['false', ''],
          ]
        : field.choices;
    if (choices.length === 0 || field.kind === 'number-or-choice') {
      return h('input', {
        ...own,
        type: 'text',
        spellcheck: 'false',
        autocomplete: 'off',
        inputmode: isNumeric(field) ? 'decimal' : 'text',
      });
    }
    return h(
      'select',
      own,
      ...choices.map(([name = '', doc = '']) => h('option', { value: name, title: doc }, name)),
    );
  }

  private text(value: FieldValue | undefined): string {
    if (value === undefined) return '';
    if (value === null) return 'inf';
    if (typeof value !== 'number') {
      return Array.isArray(value) ? JSON.stringify(value) : String(value);
    }
    return String(Number((value / shownUnit(this.field)[1]).toPrecision(8)));
  }

  private place(value: FieldValue | undefined): void {
    if (!this.slider) return;
    const isNumber = typeof value === 'number';
    if (isNumber && document.activeElement !== this.slider) this.scale = scaleOf(this.field, value);
    this.slider.hidden = !isNumber || this.scale === null;
    if (!isNumber || !this.scale) return;
    if (
      document.activeElement !== this.slider ||
      this.scale.toValue(Number(this.slider.value)) !== value
    ) {
      this.slider.value = String(this.scale.toPosition(value));
    }
    this.slider.setAttribute('aria-valuetext', `${this.text(value)} ${shownUnit(this.field)[0]}`);
  }

  private slid(): void {
    if (!this.slider || !this.scale) return;
    const si = this.scale.toValue(Number(this.slider.value));
    this.input.value = this.text(si);
    this.actions.move(this.field, si);
  }
}

/** Symbol and meaning: a description opens with the symbol where there is one. */
function explained(field: Field): [string, string] {
  const symbol = /^([^\s,;:]{1,5}), /.exec(field.doc)?.[1] ?? '';
  const meaning = fieldMeaning(field);
  const told = symbol && meaning !== field.doc ? `${symbol}, ${meaning}` : meaning;
  const choices = field.choices.map(([name, doc]) => `${name}: ${doc}`).join('\n');
  return [symbol, [told, field.definition, choices].filter(Boolean).join('\n')];
}

/** A unit with raised exponents. */
export function prettyUnit(unit: string): string {
  return unit
    .replace(/\^2/g, '²')
    .replace(/\^3/g, '³')
    .replace(/\^4/g, '⁴')
    .replace('degC', '°C')
    .replace(/^deg$/, '°')
    .replace(/\bum\b/, 'µm')
    .replace(/\bug\b/, 'µg');
}
