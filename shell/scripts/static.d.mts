import type { Server } from 'node:http';

export function fileFor(folder: string, url: string): string | null;
export function encodingsFor(accept: string | undefined): [name: string, suffix: string][];
export function sizeOf(file: string): Promise<number | null>;
export function serve(folder: string, port: number): Promise<Server>;
