/**
 * The interface of a model: its document, requests, plants, parts and files. App, element, writers and command line
 * know this interface and the index (index.ts), but no model. A model is a folder beside this file whose index.ts
 * exports one as `model`; docs/adding-a-model.md shows how to add one. Types only.
 *
 * How a page draws and edits a model is in page_model.ts, so that the command line and workers load neither Lit nor
 * three.js.
 */
import type { Block } from "../core/container";
import type { Answer } from "../core/core";
import type { PointLabels } from "../formats/about";
import type { Message } from "../locale/texts";
import type { TraceRequest } from "../plant/derivation_trace";
import type { Part } from "../plant/part";
import type { Plant } from "../plant/plant";
import type { Descriptor } from "../specimen/measures";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";
import type { Levers } from "../targets/lever";
import type { Member, MemberRequest } from "./member";

export type { Member, MemberMesh, MemberRequest, TextPosition } from "./member";

/** The parts of a growth that are requested. */
export interface GrowthOptions {
	/** Whether to make triangles besides segments and organs; the default is true. */
	meshes?: boolean;
	/** Whether to measure the plant; the default is true, but false for a preview. */
	measures?: boolean;
	/**
	 * Whether the plant is a preview that the next step of a drag soon replaces: the model may leave out details. The
	 * default is false.
	 */
	preview?: boolean;
	/** Whether to return the derived string, for models with `strings`; the default is false. */
	string?: boolean;
	/** Number of derivation steps, in place of the number in the document or text, for models with derivations. */
	steps?: number;
	/** The derivation step to trace, for models with `traces`; the default is none. */
	trace?: TraceRequest;
	/** Whether to return the whole topology, for models that have one; the default is true, but false for a preview. */
	map?: boolean;
	/** Whether to make meshes at four levels of detail, for models with `levels`; the default is false. */
	levels?: boolean;
}

/** Specimens of other models that a plant contains. */
export interface Members<G extends Plant = Plant> {
	/** The specimens to grow for this plant, each once. */
	requests(grown: G): readonly MemberRequest[];
	/** The plant with the members that have grown so far, in the order of `requests`. */
	joined(grown: G, members: readonly (Member | undefined)[]): G;
}

/** Measures that can be set as targets. */
export interface Targets<S extends Specimen = Specimen> {
	/** Keys of the measures that a specimen can reach. */
	measures(specimen: S): readonly string[];
	/**
	 * Loads the function that lists the levers of a specimen for all measures that are targeted together; in a module
	 * of its own.
	 */
	levers(): Promise<(specimen: S, measures: readonly string[]) => Levers<S>>;
}

/** A format that `Download` and the command line's `--out` offer besides those of every plant. */
export interface Format<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** The name for programs: `csv`. */
	readonly key: string;
	readonly title: string;
	/** One line of description. */
	readonly about: string;
	/** The end of the file's name, after the plant's name: `-berries.csv`. */
	readonly suffix: string;
	/** The media type of the file. */
	readonly type: string;
	/** Whether the file contains measures. */
	readonly measured?: true;
	/** Whether the format suits this plant; absent where it suits every plant. */
	applies?(grown: G): boolean;
	/**
	 * Makes the file.
	 * @param link the address that restores the specimen
	 */
	make(grown: G, specimen: S, link: string): Promise<string | Uint8Array<ArrayBuffer>>;
}

export interface Model<S extends Specimen = Specimen, G extends Plant = Plant> extends ModelSchema<S> {
	/** Whether the meaning of the model's links is not frozen yet: the page and `--list` label it as a preview. */
	readonly preview?: true;
	/** The heading of the model: "Grape bunch". */
	readonly title: string;
	/** The method by which the model grows plants, as the gallery names it: "Growth grammars"; by default `title`. */
	readonly shelf?: string;
	/** The noun for one plant in sentences: "the last bunch stays". */
	readonly plantName: string;
	/**
	 * The file of the model's core, beside the others: `bunch.wasm`; or a whole address, for a model from elsewhere.
	 */
	readonly wasm: string;

	/** Whether wind does not move the model's plants, everywhere or in files only. */
	readonly still?: true | "in files";
	/** False where the model's presets have no pictures in public/gallery. */
	readonly pictures?: false;
	/** Whether the model can return the derived string of its grammar. */
	readonly strings?: true;
	/** Whether the model can trace the derivation of its grammar, step by step. */
	readonly traces?: true;

	/**
	 * Fetches resources that a specimen's request and plant need besides the core; await it before `encode`. Without
	 * them the plant lacks these resources, and a note reports it; the next call tries again.
	 */
	prepare?(specimen: S): Promise<void> | undefined;
	/**
	 * Fetches only the resources that a first picture needs, in place of `prepare`; the rest follows once the picture
	 * is drawn.
	 */
	sketch?(specimen: S): Promise<void> | undefined;
	/**
	 * Makes the closed mesh of a file the boundary of the plant, for models that have boundaries.
	 * @throws Error with the reason in plain words where the file holds no mesh
	 */
	bounded?(specimen: S, file: File): Promise<S>;
	/**
	 * Encodes a specimen as a request to the core: `model`, `seed`, `outputs`, `parameters` and other columns of the
	 * model.
	 * @throws CoreError where the specimen cannot be encoded: it has not passed through specimen/restore.ts
	 */
	encode(specimen: S, options?: GrowthOptions): Block[];
	/** Decodes the core's answer for a specimen: plain data, because it is cloned into the worker that makes files. */
	read(answer: Answer, specimen: S): G;
	/**
	 * Whether the plant depends on its age, for models whose texts may not use it; call it after `prepare`. Absent: as
	 * in the table.
	 */
	ages?(specimen: S): boolean;
	/**
	 * The parts of the plant, for the scene and the exporters, which run in a worker: meshes or instances with their
	 * materials.
	 */
	parts(grown: G, specimen: S): Iterable<Part>;
	/**
	 * The parts at four levels of detail, from near to far, of a plant grown with `levels`; absent of models without
	 * levels.
	 */
	levels?(grown: G, specimen: S): readonly (readonly Part[])[];
	/** Specimens of other models in the plant, grown by their own cores once the plant has grown; absent: none. */
	readonly members?: Members<G>;
	/** Whether some parts are instances of one mesh, or similar ones; absent: true where organs have meshes. */
	instanced?(grown: G): boolean;
	/** The title of a specimen that no longer carries its preset's title; absent or undefined: the preset's title. */
	titled?(specimen: S): string | undefined;
	/** Describes the plant in a few plain words, for readers and screen readers: "22 cm long, with 73 berries". */
	summary(grown: G, specimen: S): string;
	/** Fields of the JSON document by key, besides segments and organs or in place of them. */
	record?(grown: G, specimen: S): object;
	/**
	 * The reason why the JSON document with its whole topology (`map`) is too large to send, and a way to request less;
	 * undefined where it is not too large. `grown` has no topology.
	 */
	heavy?(grown: G): Message | undefined;
	/** Descriptors with classes, besides those of the measures. */
	readonly descriptors?: readonly Descriptor<S>[];
	/** Labels of points in point clouds; absent: the kinds of the plant's parts, in their order. */
	readonly labels?: PointLabels;
	/** Extra properties in files with meshes (glTF), by key, besides those of every plant. */
	extras?(grown: G, specimen: S): Record<string, unknown>;
	/**
	 * Translates a text in another form that the model claims into a grammar; undefined for a text that is a grammar
	 * already. Rejects with a TextError.
	 */
	translated?(text: string): Promise<string> | undefined;
	/** File formats besides those of every plant. */
	readonly formats?: readonly Format<S, G>[];

	/** Measures that can be set as targets, if any. */
	readonly targets?: Targets<S>;
}
