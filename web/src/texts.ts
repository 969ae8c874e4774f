/** All texts of the page in English, German and Chinese; what fields mean is in the catalogue. */

import type { Field } from './catalogue';
import { labelled } from './quantity';
import type { Column } from './solver/protocol';

/** Languages of the page. */
export const LANGUAGES = { en: 'English', de: 'Deutsch', zh: '中文' } as const;

/** A language of the page. */
export type Language = keyof typeof LANGUAGES;

const TEXTS = {
  subtitle: ['rolling contact', 'Rollkontakt', '滚动接触'],
  case: ['Case', 'Fall', '算例'],
  gallery: ['Gallery', 'Galerie', '示例库'],
  own_case: ['own case', 'eigener Fall', '自定义算例'],
  open: ['Open files', 'Dateien öffnen', '打开文件'],
  edit: ['Edit case', 'Fall bearbeiten', '编辑算例'],
  share: ['Copy link', 'Link kopieren', '复制链接'],
  copied: ['Copied', 'Kopiert', '已复制'],
  not_in_link: [
    'Copied without files too large for a link:',
    'Kopiert ohne zu große Dateien:',
    '已复制，但未包含过大的文件：',
  ],
  copy: ['Copy', 'Kopieren', '复制'],
  save: ['Save', 'Speichern', '保存'],
  save_toml: ['Case (TOML)', 'Fall (TOML)', '算例 (TOML)'],
  save_csv: ['Fields or curve (CSV)', 'Felder oder Kurve (CSV)', '场数据或曲线 (CSV)'],
  save_json: ['Results (JSON)', 'Ergebnisse (JSON)', '结果 (JSON)'],
  save_svg: ['Figures (SVG)', 'Bilder (SVG)', '图形 (SVG)'],
  save_png: ['This view (PNG)', 'Diese Ansicht (PNG)', '当前视图 (PNG)'],
  same: [
    'The same by command and in Python',
    'Dasselbe als Befehl und in Python',
    '等效的命令行与 Python',
  ],
  command_line: ['Command', 'Befehl', '命令行'],
  language: ['Language', 'Sprache', '语言'],
  theme: ['Light or dark', 'Hell oder dunkel', '浅色或深色'],
  close: ['Close', 'Schließen', '关闭'],
  apply: ['Apply', 'Übernehmen', '应用'],
  not_a_number: [
    'is not a number, such as 0.02',
    'ist keine Zahl wie 0,02',
    '不是数值（例如 0.02）',
  ],
  only_steady: [
    'Curves are for steady rolling: this case rolls over time.',
    'Kurven gelten für stationäres Rollen: Dieser Fall verläuft über der Zeit.',
    '曲线仅适用于稳态滚动：该算例为瞬态过程。',
  ],
  at_end: ['At the end of the time', 'Am Ende der Zeit', '终止时刻的结果'],
  cancel: ['Cancel', 'Abbrechen', '取消'],
  cancelled: ['Cancelled.', 'Abgebrochen.', '已取消。'],
  residual: ['residual', 'Residuum', '残差'],
  views: ['Views', 'Ansichten', '视图'],
  patch: ['Patch', 'Kontaktfläche', '接触斑'],
  curve: ['Curve', 'Kraftschlusskurve', '蠕滑曲线'],
  wheel: ['Wheel on rail', 'Rad auf Schiene', '轮轨接触'],
  conditions: ['Conditions', 'Bedingungen', '工况参数'],
  all_fields: ['Find a field', 'Feld suchen', '查找参数'],
  preset: ['preset', 'Vorlage', '预设'],
  default: ['default', 'Vorgabe', '默认'],
  reset: ['Reset', 'Zurücksetzen', '重置'],
  results: ['Results', 'Ergebnisse', '结果'],
  summary: ['Summary of the program', 'Zusammenfassung des Programms', '程序摘要'],
  warnings: ['Warnings', 'Warnungen', '警告'],
  problems_of_task: ['This cannot be computed', 'Das ist nicht berechenbar', '无法计算'],
  problems: ['This case cannot be solved', 'Dieser Fall ist nicht lösbar', '该算例无法求解'],
  take_out: ['Take out', 'Entfernen:', '移除'],
  line: ['line', 'Zeile', '行'],
  converged: ['converged', 'konvergiert', '已收敛'],
  not_converged: ['not converged', 'nicht konvergiert', '未收敛'],
  solving: ['solving …', 'rechnet …', '求解中…'],
  solved_in: ['solved in', 'gelöst in', '求解用时'],
  quick: [
    'while it moves: Kik–Piotrowski, FASTSIM',
    'solange es bewegt wird: Kik–Piotrowski, FASTSIM',
    '移动时：Kik–Piotrowski、FASTSIM',
  ],
  pin: ['Pin to compare', 'Anheften', '固定以比较'],
  unpin: ['Unpin', 'Loslösen', '取消固定'],
  present: ['present', 'jetzt', '当前'],
  pinned: ['pinned', 'angeheftet', '固定'],
  difference: ['change', 'Änderung', '差值'],
  quantity: ['Quantity', 'Größe', '物理量'],
  contact: ['Contact', 'Kontakt', '接触点'],
  arrows: ['traction arrows', 'Schubspannungspfeile', '切应力箭头'],
  border: ['border of stick', 'Haftgrenze', '黏着区边界'],
  rolling: ['rolling', 'Rollrichtung', '滚动方向'],
  stick: ['stick', 'Haften', '黏着'],
  slip: ['slip', 'Gleiten', '滑动'],
  section_at: ['along rolling at', 'in Rollrichtung bei', '沿滚动方向，位于'],
  friction_limit: ['friction limit μ p', 'Reibgrenze μ p', '摩擦极限 μ p'],
  no_fields: [
    'This method finds forces only: there are no fields to show.',
    'Dieses Verfahren bestimmt nur Kräfte: Es gibt keine Felder.',
    '该方法只计算合力，没有场数据可显示。',
  ],
  below: ['Below the surface', 'Unter der Oberfläche', '表面以下'],
  temperature: ['Temperature', 'Temperatur', '温度'],
  subsurface: ['Stresses', 'Spannungen', '应力'],
  wear: ['Wear and shakedown', 'Verschleiß und Shakedown', '磨损与安定'],
  below_hint: [
    'Computed when asked for, at the present conditions.',
    'Wird auf Wunsch für die jetzigen Bedingungen berechnet.',
    '按需对当前工况计算。',
  ],
  outdated: [
    'The case has changed since.',
    'Der Fall hat sich seither geändert.',
    '此后算例已改变。',
  ],
  play: ['Play', 'Abspielen', '播放'],
  pause: ['Pause', 'Anhalten', '暂停'],
  time: ['time', 'Zeit', '时间'],
  force: ['force', 'Kraft', '力'],
  roughness: ['Roughness', 'Rauheit', '粗糙度'],
  new_surface: ['New surface', 'Neue Oberfläche', '新表面'],
  find_spots: ['Spots and k_c', 'Kontaktflecken und k_c', '微接触斑与 k_c'],
  abscissa: ['Vary', 'Variieren', '变化量'],
  range_end: ['up to', 'bis', '至'],
  points: ['points', 'Punkte', '点数'],
  ordinate: ['Show', 'Zeigen', '显示'],
  present_point: [
    'Present point: drag it along the curve, or use the arrow keys',
    'Arbeitspunkt: auf der Kurve ziehen oder mit Pfeiltasten bewegen',
    '当前工作点：可沿曲线拖动，或使用方向键',
  ],
  adhesion_map: ['Adhesion map', 'Kraftschlusskennfeld', '黏着图谱'],
  over: ['over', 'über', '随'],
  from: ['from', 'von', '从'],
  to: ['to', 'bis', '到'],
  compute: ['Compute', 'Berechnen', '计算'],
  no_profiles: [
    'This case has no profiles of wheel and rail.',
    'Dieser Fall hat keine Profile von Rad und Schiene.',
    '该算例没有车轮和钢轨廓形。',
  ],
  open_profiles: ['Open a wheel on a rail', 'Ein Rad auf einer Schiene öffnen', '打开轮轨接触算例'],
  drag_wheel: [
    'Drag the wheel sideways, or use the arrow keys: lateral position',
    'Rad seitlich ziehen oder mit Pfeiltasten verschieben: Querverschiebung',
    '横向拖动车轮或使用方向键：横移量',
  ],
  seen_along: [
    'to the left ←, seen along rolling',
    'nach links ←, in Rollrichtung gesehen',
    '向左 ←，沿滚动方向观察',
  ],
  zoom_contact: ['zoom to the contact', 'Kontakt vergrößern', '放大接触区'],
  wheelset: [
    'Wheelset over its lateral position',
    'Radsatz über der Querverschiebung',
    '轮对横移特性',
  ],
  radius_difference: ['rolling radius difference', 'Rollradiendifferenz', '滚动圆半径差'],
  rigid: ['rigid', 'starr', '刚性'],
  conicity: ['equivalent conicity', 'äquivalente Konizität', '等效锥度'],
  normal_load: ['normal load', 'Normalkraft', '法向力'],
  refused: ['This file cannot be opened', 'Diese Datei wird nicht geöffnet', '无法打开该文件'],
  no_input: [
    'neither a case nor a file that one reads',
    'weder ein Fall noch eine Datei, die einer liest',
    '既不是算例，也不是算例可读取的文件',
  ],
  which_body: ['Whose profile is it?', 'Wessen Profil ist das?', '这是哪个部件的廓形？'],
  of_wheel: ['wheel', 'Rad', '车轮'],
  of_rail: ['rail', 'Schiene', '钢轨'],
  other_file: ['a file that the case names', 'eine im Fall genannte Datei', '算例引用的文件'],
  drop_here: [
    'Drop cases (TOML), profiles or other files',
    'Fälle (TOML), Profile oder andere Dateien ablegen',
    '拖放算例 (TOML)、廓形或其他文件',
  ],
  skip: ['Skip to the view', 'Zur Ansicht springen', '跳到视图'],
  surface_3d: ['surface', 'Fläche', '曲面'],
  damaged_link: [
    'The case of this link cannot be read.',
    'Der Fall dieses Links ist nicht lesbar.',
    '无法读取该链接中的算例。',
  ],
  failed_start: [
    'The solver could not be loaded.',
    'Der Löser konnte nicht geladen werden.',
    '无法加载求解器。',
  ],
} satisfies Record<string, [string, string, string]>;

let language: Language = 'en';

/** What another language calls something, and what that means. */
type Word = [name: string, meaning?: string];

/**
 * Sections of a case by their names; fields by their paths, or by their names where those of
 * several sections are alike; columns of results by their paths or by their quantities; what is
 * counted in computing. English, which the catalogue and the columns have, stands in for the rest.
 */
export interface Words {
  sections: Record<string, Word>;
  names: Record<string, Word>;
}

const LOADED = { de: () => import('./languages/de'), zh: () => import('./languages/zh') };

let words: Words = { sections: {}, names: {} };

/** The language of the page. */
export function currentLanguage(): Language {
  return language;
}

/** Chooses the language, and loads its words: a stored one, else that of the browser. */
export async function chooseLanguage(): Promise<void> {
  const wanted = localStorage.getItem('language') ?? navigator.language.slice(0, 2);
  language = wanted in LANGUAGES ? (wanted as Language) : 'en';
  document.documentElement.lang = language;
  if (language !== 'en') words = (await LOADED[language]()).default;
}

/** A text in the language of the page. */
export function t(key: keyof typeof TEXTS): string {
  return TEXTS[key][Object.keys(LANGUAGES).indexOf(language)] ?? TEXTS[key][0];
}

/** Words of a name. */
function plain(name: string): string {
  return name.replace(/[_.]/g, ' ');
}

/** A name in the language of the page; in English its description, else the name itself. */
export function nameOf(name: string, english = plain(name)): string {
  return words.names[name]?.[0] ?? english;
}

/** What a section is called and what it is about. */
export function sectionWords({ name, doc }: { name: string; doc: string }): Word {
  const [called = plain(name), meaning = doc] = words.sections[name] ?? [];
  return [called, meaning];
}

/** What a field is called. */
export function fieldName({ path, name }: { path: string; name: string }): string {
  return words.names[path]?.[0] ?? nameOf(name);
}

/** What a field means. */
export function fieldMeaning({ path, name, doc }: Pick<Field, 'path' | 'name' | 'doc'>): string {
  return words.names[path]?.[1] ?? words.names[name]?.[1] ?? doc;
}

/** What a column of results is called. */
export function columnName(
  name: string,
  column: Pick<Column, 'quantity' | 'long_name'> | undefined,
  english = column?.long_name,
): string {
  const own = name.includes('.') ? words.names[name]?.[0] : undefined;
  return own ?? nameOf(column?.quantity ?? name, english ?? plain(name));
}

/** What a column means, for a tooltip: name, symbol and SI unit, and its defining equation. */
export function explained(name: string, column: Column): string {
  const meaning = [columnName(name, column), column.symbol].filter(Boolean).join(', ');
  return [labelled(meaning, column.units), column.definition].filter(Boolean).join('\n');
}
