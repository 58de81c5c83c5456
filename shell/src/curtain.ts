import { say } from './words';

/// What covers the stage until there is something on it: progress, or why nothing comes.
const byId = (id: string): HTMLElement => document.getElementById(id)!;

export type Trouble = 'unsupported' | 'download' | 'script' | 'webgl' | 'context' | 'failed';

const messages: Record<Trouble, [title: string, text: string, retry: boolean]> = {
  unsupported: [
    'This browser cannot run the figure',
    'It needs WebAssembly, which every current browser has. The text beside this reads just as well without.',
    false,
  ],
  download: ['The figure did not arrive', 'The connection broke off, or the server did not answer.', true],
  script: ['The figure did not arrive', 'The connection broke off, or the server did not answer.', true],
  webgl: [
    'The figure needs WebGL2',
    'This browser does not offer it. It may be switched off in its settings, or the graphics driver may be too old.',
    false,
  ],
  context: [
    'The graphics card took a break',
    'The figure comes back by itself as soon as the browser gets hold of it again. Nothing that you did is lost.',
    false,
  ],
  failed: ['The figure stopped', 'Something went wrong inside it. Loading the page again usually helps.', true],
};

export function showProgress(share: number): void {
  byId('stage').dataset['state'] = 'loading';
  byId('trouble').hidden = true;
  byId('loading').hidden = false;
  (byId('progress') as HTMLProgressElement).value = share;
  byId('loading-text').textContent =
    share < 1 ? say('Fetching the figure, {} %', Math.floor(100 * share)) : say('Setting up the figure');
}

export function showTrouble(trouble: Trouble, retry: () => void): void {
  const [title, text, again] = messages[trouble];
  byId('stage').dataset['state'] = 'trouble';
  byId('loading').hidden = true;
  byId('trouble-title').textContent = say(title);
  byId('trouble-text').textContent = say(text);
  const button = byId('retry') as HTMLButtonElement;
  button.hidden = !again;
  button.onclick = retry;
  byId('trouble').hidden = false;
}

export function raise(): void {
  byId('stage').dataset['state'] = 'ready';
  byId('trouble').hidden = true;
  byId('loading').hidden = true;
}
