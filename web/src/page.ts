/** The page as a whole: head, controls, views and results around one case. */
import type { Catalogue } from './catalogue';
import type { CaseModel } from './case/model';
import { FIRST_CASE } from './case/gallery';
import { hashOf, leftOut, namesCase, restore, viewOf } from './case/share';
import { Panel } from './controls/panel';
import { debounced, h } from './dom';
import { Explorer, type Result } from './explorer';
import { Head } from './head';
import { problemList } from './report/problems';
import { Running } from './report/running';
import { summary } from './report/summary';
import type { Lane } from './solver/lane';
import type { Described, Problem } from './solver/protocol';
import { t } from './texts';
import { onTheme } from './theme';
import { AdhesionMap } from './views/adhesion_map';
import { CurveView } from './views/curve';
import { PatchView } from './views/patch';
import { TaskPanel } from './views/task_panel';
import { Tabs } from './views/tabs';
import { WheelView } from './views/wheel';

/** Field of the seed of a generated surface. */
const SEED = 'contact_law.roughness.seed';
/** A field of every case with a generated surface. */
const GENERATED = 'contact_law.roughness.longest_wavelength';
/** A field of every case with a measured one. */
const MEASURED = 'contact_law.roughness.file';

/** All that is seen. */
export class Page {
  readonly elements: HTMLElement[];
  private readonly explorer: Explorer;
  private readonly panel: Panel;
  private readonly patch = new PatchView(() => this.chooseContact());
  private readonly curve: CurveView;
  private readonly map: AdhesionMap;
  private readonly wheel: WheelView;
  private readonly roughness: TaskPanel;
  private readonly tabs: Tabs;
  private readonly head: Head;
  private readonly damaged = h('div', {});
  private readonly problems = h('div', {});
  private readonly running = new Running(() => this.explorer.cancel());
  private readonly results = h('div', { class: 'results' });
  private readonly pin = h(
    'button',
    { type: 'button', 'aria-pressed': 'false', onclick: () => this.togglePin() },
    t('pin'),
  );
  private readonly columns = h('div', { class: 'columns undescribed' });
  private pinned: Result | null = null;
  private readonly storeHash = debounced(400, () => void this.writeHash());
  private written = '';

  constructor(
    catalogue: Catalogue,
    private readonly model: CaseModel,
    contact: Lane,
    long: Lane,
  ) {
    this.explorer = new Explorer(model, contact, long, {
      described: (described) => this.describe(described),
      solving: () => {
        this.problems.replaceChildren();
        this.results.setAttribute('aria-busy', 'true');
        this.running.begin();
      },
      progress: (progress) => this.running.tell(progress),
      cancelled: () => this.cancelled(),
      solved: (result) => this.show(result),
      failed: (problems) => this.fail(problems),
    });
    this.panel = new Panel(catalogue, model);
    this.curve = new CurveView(catalogue, model, long);
    this.map = new AdhesionMap(catalogue, model, long, this.curve);
    this.wheel = new WheelView(catalogue, model, long);
    this.roughness = this.roughnessPanel(long);
    const below = new TaskPanel(
      t('below'),
      ['temperature', 'subsurface', 'wear'].map((task) => ({
        task,
        label: t(task as 'temperature' | 'subsurface' | 'wear'),
      })),
      model,
      long,
    );
    this.tabs = new Tabs(
      [
        {
          name: 'patch',
          label: t('patch'),
          children: [this.patch.element, below.element, this.roughness.element],
        },
        { name: 'curve', label: t('curve'), children: [this.curve.element, this.map.element] },
        { name: 'wheel', label: t('wheel'), children: [this.wheel.element] },
      ],
      (name) => this.changeView(name),
    );
    this.head = new Head(
      this.explorer,
      () => this.shownTask(),
      () => this.tabs.panel,
      () => this.link(),
      () => leftOut(model),
    );
    const side = h(
      'aside',
      { class: 'side described', 'aria-label': t('results') },
      h('header', {}, h('h2', {}, t('results')), this.pin),
      this.results,
    );
    const main = h(
      'main',
      { id: 'view', tabindex: -1 },
      this.damaged,
      this.tabs.list,
      this.tabs.body,
      h('div', { class: 'told' }, this.running.element, this.problems),
    );
    const controls = h(
      'aside',
      { class: 'controls described', 'aria-label': t('conditions') },
      this.panel.element,
    );
    this.elements = [
      h(
        'a',
        {
          href: '#view',
          class: 'skip',
          onclick: (event) => {
            event.preventDefault();
            main.focus();
          },
        },
        t('skip'),
      ),
      this.head.element,
      this.columns,
    ];
    this.columns.append(controls, main, side);
    model.listen((change) => {
      if (change === 'opened') this.clear();
    });
  }

  /** Shows the case and the view of the link, and follows links. */
  async begin(): Promise<void> {
    const isNamed = namesCase(location.hash);
    this.tabs.choose(viewOf(location.hash) ?? 'patch');
    onTheme(() => {
      this.patch.refresh();
      this.map.refresh();
      this.wheel.refresh();
    });
    window.addEventListener('hashchange', () => {
      if (location.hash === this.written) return;
      this.tabs.choose(viewOf(location.hash) ?? this.tabs.chosen);
      void this.follow();
    });
    if (!(await this.follow())) {
      await restore(this.model, `#case=${FIRST_CASE}`);
      this.tellDamaged(isNamed);
    }
  }

  /** Opens the case of the link; without one the present case stays. */
  private async follow(): Promise<boolean> {
    const { hash } = location;
    const isRestored = await restore(this.model, hash);
    this.tellDamaged(!isRestored && namesCase(hash));
    return isRestored;
  }

  private tellDamaged(isDamaged: boolean): void {
    const told = h('p', { class: 'problems', role: 'alert' }, t('damaged_link'));
    this.damaged.replaceChildren(...(isDamaged ? [told] : []));
  }

  /** Nothing of another case is seen. */
  private clear(): void {
    this.tellDamaged(false);
    this.running.end();
    this.problems.replaceChildren();
    this.results.replaceChildren();
    this.tabs.body.classList.add('blank');
  }

  private roughnessPanel(long: Lane): TaskPanel {
    const renew = () => {
      const seed = this.explorer.described?.fields.values[SEED];
      this.model.assign([[SEED, String((typeof seed === 'number' ? seed : 1) + 1)]]);
    };
    return new TaskPanel(
      t('roughness'),
      [
        { label: t('find_spots'), task: 'roughness', fields: [GENERATED, MEASURED] },
        // The solution of the changed case takes the time of the micro-model: no task besides.
        { label: t('new_surface'), task: renew, fields: [GENERATED] },
      ],
      this.model,
      long,
    );
  }

  private describe(described: Described): void {
    this.columns.classList.remove('undescribed');
    this.panel.show(described.fields);
    this.roughness.describe(described.fields);
    this.head.show();
    this.wheel.describe(described);
    this.map.show(described.fields);
    const isTransient = this.explorer.isTransient();
    this.curve.describe(isTransient);
    this.map.element.hidden = isTransient;
    this.storeHash();
  }

  private show(result: Result): void {
    this.problems.replaceChildren();
    this.ended();
    this.tabs.body.classList.remove('old', 'blank');
    this.pin.disabled = false;
    this.draw(result);
    document.documentElement.dataset['solved'] = String(performance.now());
  }

  /** Draws a result beside the pinned one. */
  private draw(result: Result): void {
    this.patch.show(result, this.pinned);
    this.wheel.show(result, this.pinned);
    this.chooseContact();
  }

  /** Shows what depends on the contact that is shown. */
  private chooseContact(): void {
    const { result } = this.explorer;
    if (!result) return;
    this.curve.show(result, this.pinned, this.patch.contactIndex);
    this.map.refresh();
    const isOpen = this.results.querySelector<HTMLDetailsElement>('.whole')?.open ?? false;
    this.results.replaceChildren(summary(result, this.pinned, this.patch.contactIndex));
    const whole = this.results.querySelector<HTMLDetailsElement>('.whole');
    if (whole) whole.open = isOpen;
    if (this.pin.disabled) this.markOutdated();
  }

  private fail(problems: Problem[]): void {
    this.ended();
    this.markOutdated();
    this.columns.classList.toggle('undescribed', !this.explorer.described);
    const assign = (values: [string, string][]) => this.model.assign(values);
    this.problems.replaceChildren(problemList(t('problems'), problems, this.model.text, assign));
    this.panel.showProblems(problems);
  }

  /** Nothing is solved any more. */
  private ended(): void {
    this.results.removeAttribute('aria-busy');
    this.running.end();
  }

  private cancelled(): void {
    this.ended();
    this.markOutdated();
    const again = h(
      'button',
      { type: 'button', onclick: () => this.explorer.again() },
      t('compute'),
    );
    this.running.end(`${t('cancelled')} `, again);
  }

  /** What is seen is not that of the case. */
  private markOutdated(): void {
    this.tabs.body.classList.add('old');
    this.pin.disabled = true;
    const hint = h('p', { class: 'status bad' }, t('outdated'));
    const isOutdated = this.explorer.result && !this.results.querySelector('.status.bad');
    if (isOutdated) this.results.prepend(hint);
  }

  private togglePin(): void {
    this.pinned = this.pinned ? null : this.explorer.result;
    this.pin.setAttribute('aria-pressed', String(this.pinned !== null));
    this.pin.textContent = t(this.pinned ? 'unpin' : 'pin');
    const { result } = this.explorer;
    if (result) this.draw(result);
  }

  private changeView(name: string): void {
    this.patch.visible = name === 'patch';
    this.curve.visible = name === 'curve';
    this.wheel.visible = name === 'wheel';
    this.storeHash();
  }

  private shownTask() {
    const isCurve = this.tabs.chosen === 'curve';
    return { task: isCurve ? ('curve' as const) : ('solve' as const), ...this.curve.request() };
  }

  private async link(): Promise<string> {
    const url = new URL(location.href);
    url.hash = await hashOf(this.model, this.tabs.chosen);
    return url.href;
  }

  private async writeHash(): Promise<void> {
    const hash = await hashOf(this.model, this.tabs.chosen);
    this.written = hash;
    history.replaceState(null, '', hash);
  }
}
