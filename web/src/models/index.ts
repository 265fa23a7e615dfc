/**
 * Every model by its name. A folder here with an index.ts that exports `model` is a model, and so is such a folder one
 * level deeper, in a family that shares its parent's files; there is no other list. The only place that imports models.
 */
import type { PageModel } from "./page_model";

/** Loads a model; a second call may give the same one. */
export type LoadModel = () => Promise<PageModel>;

/** The model of links that name none. */
export const DEFAULT_MODEL = "bunch";

const folders = import.meta.glob<PageModel>("./*/index.ts", { import: "model" });

/** Loaders by model name: the default first, then in alphabetical order, then added models. */
const loaders = new Map<string, LoadModel>(
	Object.entries(folders)
		.map(([path, load]) => [path.split("/").at(-2) as string, load] as const)
		.sort(([a], [b]) => Number(b === DEFAULT_MODEL) - Number(a === DEFAULT_MODEL) || (a < b ? -1 : 1)),
);
const loading = new Map<string, Promise<PageModel>>();

/**
 * Adds a model from elsewhere, or replaces one: for pages that bring their own, and for tests.
 * @param name as links write it; the same as the model's `name`
 */
export function addModel(name: string, load: LoadModel): void {
	loaders.set(name, load);
	loading.delete(name);
}

/** Names of all models; the default is the first. */
export function modelNames(): readonly string[] {
	return [...loaders.keys()];
}

/** Returns whether there is a model of a name. */
export function isModel(name: string): boolean {
	return loaders.has(name);
}

/**
 * Returns the model of that name, loaded once; the default model where there is none of that name. The next call after
 * a failed load tries again.
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
