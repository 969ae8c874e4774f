/** All fields that have an effect in the case, by section; generated from the catalogue. */
import { siOf, tomlOfTyped, type Catalogue, type Field, type Section } from '../catalogue';
import type { CaseModel } from '../case/model';
import { h } from '../dom';
import type { Fields, Problem } from '../solver/protocol';
import { sectionWords, t } from '../texts';
import { FieldControl, type ControlActions } from './field_control';

/** Sections that come first, in order; the others follow as in the catalogue. */
const FIRST = ['kinematics', 'normal', 'friction', 'wheelset', 'wheel', 'rail', 'contact_law'];
/** Sections that are open at first. */
const OPEN = ['kinematics', 'normal', 'friction', 'wheelset'];

interface Group {
  section: Section;
  element: HTMLDetailsElement;
  controls: { field: Field; control: FieldControl }[];
}

/** The controls of the case. */
export class Panel {
  readonly element = h('form', { class: 'panel', onsubmit: (event) => event.preventDefault() });
  private readonly groups: Group[];
  private readonly search: HTMLInputElement;
  private fields: Fields | null = null;
  private problems: Problem[] = [];

  constructor(
    private readonly catalogue: Catalogue,
    private readonly model: CaseModel,
  ) {
    const rank = ({ name }: Section) => {
      const place = FIRST.indexOf(name);
      return place < 0 ? FIRST.length : place;
    };
    const sections = [...catalogue.sections].sort((one, other) => rank(one) - rank(other));
    this.groups = sections.filter(({ name }) => name).map((section) => this.group(section));
    this.search = h('input', {
      type: 'search',
      placeholder: t('all_fields'),
      'aria-label': t('all_fields'),
      oninput: () => this.refresh(),
    });
    this.element.append(
      this.search,
      this.conditions(),
      ...this.groups.map(({ element }) => element),
    );
  }

  /** Shows the fields of the case as it was read. */
  show(fields: Fields): void {
    this.fields = fields;
    this.problems = [];
    this.refresh();
  }

  /** Shows what is wrong at the fields concerned. */
  showProblems(problems: Problem[]): void {
    this.problems = problems;
    this.refresh();
  }

  private group(section: Section): Group {
    const actions: ControlActions = {
      move: (field, si) => this.model.move(field, si),
      type: (field, text) => {
        if (text.trim() === '') this.clear(field.path);
        else this.model.assign([[field.path, tomlOfTyped(field, text)]]);
      },
      reset: (field) => this.model.reset([field.path]),
    };
    const controls = section.fields.map((field) => ({
      field,
      control: new FieldControl(field, actions),
    }));
    const [title, meaning] = sectionWords(section);
    const element = h(
      'details',
      { class: 'group' },
      h('summary', { title: meaning ?? '' }, title),
      this.presets(section.name, title),
      ...controls.map(({ control }) => control.element),
    );
    element.open = OPEN.includes(section.name);
    return { section, element, controls };
  }

  /** Takes a value back; one of the file is taken out of the case. */
  private clear(path: string): void {
    const isOfFile = !this.model.assignments.has(path) && this.fields?.given.includes(path);
    if (isOfFile) this.model.assign([[path, '']]);
    else this.model.reset([path]);
  }

  /** Presets of a section, or of bodies where they are given for a wheel. */
  private presets(section: string, title: string): HTMLElement | string {
    const isFor = (given: string) => given === section || (given === 'wheel' && section === 'rail');
    return this.presetChoice(
      this.catalogue.presets.filter((preset) => isFor(preset.section)),
      section,
      [t('preset'), title],
    );
  }

  /** Presets of several sections at once. */
  private conditions(): HTMLElement | string {
    return this.presetChoice(
      this.catalogue.presets.filter((preset) => preset.section === ''),
      '',
      [t('conditions'), ''],
    );
  }

  private presetChoice(
    presets: Catalogue['presets'],
    section: string,
    [label, of]: [string, string],
  ): HTMLElement | string {
    if (presets.length === 0) return '';
    const option = (preset: (typeof presets)[number], index: number) =>
      h(
        'option',
        { value: index, title: `${preset.doc}\n${preset.source}` },
        `${section ? '' : `${preset.group}: `}${preset.name.replace(/_/g, ' ')}`,
      );
    const choice = h(
      'select',
      { 'aria-label': `${label} ${of}`.trim() },
      h('option', { value: '' }, `${label} …`),
      ...presets.map(option),
    );
    choice.addEventListener('change', () => {
      const preset = presets[Number(choice.value)];
      const path = (name: string) => (section ? `${section}.${name}` : name);
      if (preset) this.model.assign(preset.fields.map(([name, toml]) => [path(name), toml]));
      choice.value = '';
    });
    return h('div', { class: 'preset' }, choice);
  }

  private refresh(): void {
    if (!this.fields) return;
    const { values, given, effective } = this.fields;
    const wanted = this.search.value.trim().toLowerCase();
    const [isEffective, isGiven] = [new Set(effective), new Set(given)];
    for (const { section, element, controls } of this.groups) {
      let shown = 0;
      for (const { field, control } of controls) {
        const { path } = field;
        const problem = this.problems.find((one) => one.field === path);
        const assigned = this.model.assignments.get(path);
        const isChanged = assigned !== undefined;
        // While something is wrong the case was not read: what it was given is shown.
        const unread = assigned && this.problems.length > 0 ? siOf(field, assigned.toml) : null;
        const isShown =
          (isEffective.has(path) || isChanged || problem !== undefined) &&
          (wanted === '' || control.matches(wanted));
        control.element.hidden = !isShown;
        if (!isShown) continue;
        shown += 1;
        control.show({
          value: assigned?.si ?? unread ?? values[path],
          isGiven: isGiven.has(path),
          isChanged,
          problem: problem ? field.requirement || problem.message : null,
        });
      }
      element.hidden = shown === 0;
      if (wanted !== '' && shown > 0) element.open = true;
      else if (wanted === '' && !OPEN.includes(section.name) && this.hadSearch)
        element.open = false;
    }
    this.hadSearch = wanted !== '';
  }

  private hadSearch = false;
}
