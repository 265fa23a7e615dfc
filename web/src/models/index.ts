/**
 * Every model by its name. A folder here with an index.ts that exports `model` is one, and so is such a folder in a folder
 * here, one of a family that shares its parent's files; nothing else has to be told of it. The one place that imports
 * models.
 */
import type { PageModel } from "./page_model";

/** Brings a model; asked for again, it may bring the same one. */
export type LoadModel = () => Promise<PageModel>;

/** What a link means that names no model. */
export const DEFAULT_MODEL = "bunch";

const folders = import.meta.glob<PageModel>("./*/index.ts", { import: "model" });

/** How each is brought, by name: the default first, then by the alphabet, then what was added. */
const loaders = new Map<string, LoadModel>(
	Object.entries(folders)
		.map(([path, load]) => [path.split("/").at(-2) as string, load] as const)
		.sort(([a], [b]) => Number(b === DEFAULT_MODEL) - Number(a === DEFAULT_MODEL) || (a < b ? -1 : 1)),
);
const loading = new Map<string, Promise<PageModel>>();

/**
 * Adds a model from elsewhere, or puts one in another's place: for pages that bring their own, and for tests.
 * @param name as links are to write it; the model's own name must be the same
 */
export function addModel(name: string, load: LoadModel): void {
	loaders.set(name, load);
	loading.delete(name);
}

/** Names of all models; the default is the first. */
export function modelNames(): readonly string[] {
	return [...loaders.keys()];
}

export function isModel(name: string): boolean {
	return loaders.has(name);
}

/**
 * The model of that name, loaded once; where there is none of that name, the default. One that could not be loaded is
 * tried again with the next call.
 */
export function modelNamed(name: string = DEFAULT_MODEL): Promise<PageModel> {
	const known = isModel(name) ? name : DEFAULT_MODEL;
	const before = loading.get(known);
	if (before) return before;
	const model = (loaders.get(known) as LoadModel)();
	loading.set(known, model);
	model.catch(() => {
		if (loading.get(known) === model) loading.delete(known);
	});
	return model;
}
