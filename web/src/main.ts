/** The page: reads the module, builds the views and shows the first case. */
import wasmUrl from '../pkg/schlupf_wasm_bg.wasm?url';
import { Catalogue } from './catalogue';
import { CaseModel } from './case/model';
import { acceptDrops } from './case/open';
import { byId, h } from './dom';
import { Page } from './page';
import { Lane } from './solver/lane';
import './style.css';
import { chooseLanguage, t } from './texts';
import { startTheme } from './theme';

async function compiled(): Promise<WebAssembly.Module> {
  const response = fetch(wasmUrl);
  try {
    return await WebAssembly.compileStreaming(response);
  } catch {
    // A server that does not know the type of the file.
    return WebAssembly.compile(await (await fetch(wasmUrl)).arrayBuffer());
  }
}

async function start(): Promise<void> {
  startTheme();
  const [module] = await Promise.all([compiled(), chooseLanguage()]);
  const [contact, long] = [new Lane(module, false), new Lane(module, true)];
  const catalogue = new Catalogue(await contact.start());
  const model = new CaseModel((path) => catalogue.field(path) !== undefined);
  const page = new Page(catalogue, model, contact, long);
  byId('page').replaceChildren(...page.elements);
  acceptDrops(model);
  await page.begin();
  if ('serviceWorker' in navigator && import.meta.env.PROD) {
    await navigator.serviceWorker.register('./service_worker.js');
  }
}

start().catch((error: unknown) => {
  byId('page').replaceChildren(
    h('p', { class: 'problems', role: 'alert' }, `${t('failed_start')} ${String(error)}`),
  );
});
