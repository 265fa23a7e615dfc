/**
 * The interface of a model: its document, requests, plants, parts and files. App, element, writers and command line know this
 * interface and the index (index.ts), but no model. A model is a folder beside this file whose index.ts exports one as `model`;
 * docs/adding-a-model.md shows how to add one. Types only.
 *
 * How a page draws and edits a model is in page_model.ts, so that the command line and workers load neither Lit nor three.js.
 */
import type { Block } from "../core/container";
import type { Answer } from "../core/core";
import type { PointLabels } from "../formats/about";
import type { TraceRequest } from "../plant/derivation_trace";
import type { Part } from "../plant/part";
import type { Plant } from "../plant/plant";
import type { Descriptor } from "../specimen/measures";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";
import type { Levers } from "../targets/lever";
import type { Member, MemberRequest } from "./member";

export type { Member, MemberMesh, MemberRequest, TextPosition } from "./member";

/** What of a growth is wanted. */
export interface GrowthOptions {
	/** Whether triangles are wanted besides segments and organs; the default is yes. */
	meshes?: boolean;
	/** Whether `measures` are wanted; the default is yes, but not in passing. */
	measures?: boolean;
	/** Whether the next is on its way, for a hand moves: what a figure can do without for so long may be left out. */
	preview?: boolean;
	/** Whether the derived string is wanted, of models that have one (`strings`); the default is no. */
	string?: boolean;
	/** Of the derivation, in place of what document and text say, of models that have one to tell of. */
	steps?: number;
	/** Which step of the derivation is to be told, of models that have one to tell of (`traces`); the default is none. */
	trace?: TraceRequest;
	/** Whether all of its topology is wanted, of models that tell it; the default is yes, but not in passing. */
	map?: boolean;
	/** Whether meshes for four distances are wanted, of models that make such (`levels`); the default is no. */
	levels?: boolean;
}

/** Specimens of other models that a plant has in it. */
export interface Members<G extends Plant = Plant> {
	/** What is to be grown for it, each once. */
	requests(grown: G): readonly MemberRequest[];
	/** The plant with those that have grown so far, in the order of `requests`. */
	joined(grown: G, members: readonly (Member | undefined)[]): G;
}

/** Measures that a person may ask for. */
export interface Targets<S extends Specimen = Specimen> {
	/** Their keys; those of a specimen. */
	measures(specimen: S): readonly string[];
	/** What moves them, of a specimen and of all that is asked at once; from a module of its own. */
	levers(): Promise<(specimen: S, asked: readonly string[]) => Levers<S>>;
}

/** Something that `Download` and the command line's `--out` give besides what every plant has. */
export interface Format<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** Its name for programs: `csv`. */
	readonly key: string;
	readonly title: string;
	/** One line about it. */
	readonly about: string;
	/** After the plant's name: `-berries.csv`. */
	readonly suffix: string;
	/** The media type of the file. */
	readonly type: string;
	/** Whether it is of what was measured. */
	readonly measured?: true;
	/** Whether it suits this growth; absent where it suits all. */
	applies?(grown: G): boolean;
	/** @param link the address that brings the specimen back */
	make(grown: G, specimen: S, link: string): Promise<string | Uint8Array<ArrayBuffer>>;
}

export interface Model<S extends Specimen = Specimen, G extends Plant = Plant> extends ModelSchema<S> {
	/** Whether what its links mean is not yet frozen: the page and `--list` say so. */
	readonly preview?: true;
	/** What a person calls it, as a heading: "Grape bunch". */
	readonly title: string;
	/** What the gallery calls its presets together, where that is not the title. */
	readonly shelf?: string;
	/** What sentences call one: "the last bunch stays". */
	readonly noun: string;
	/** The file of its core, beside the others: `bunch.wasm`; or a whole address, for a model from elsewhere. */
	readonly wasm: string;

	/** Whether wind leaves its plants alone, everywhere or in files. */
	readonly still?: true | "in files";
	/** Whether its presets have pictures in public/gallery; absent where they have. */
	readonly pictures?: false;
	/** Whether it tells the string that its grammar has derived, where that is asked for. */
	readonly strings?: true;
	/** Whether it tells how its grammar is derived, step by step, where that is asked for. */
	readonly traces?: true;

	/**
	 * Fetches what a specimen's request and plant need besides the core, where there is such: to be awaited before `encode`.
	 * Where that fails, or nobody waits, the plant is without it, and a note says so; the next call tries again.
	 */
	prepare?(specimen: S): Promise<void> | undefined;
	/** Fetches what a first picture can do with in place of that, where there is such: the rest follows when it is drawn. */
	sketch?(specimen: S): Promise<void> | undefined;
	/**
	 * Takes the closed mesh of a file as what bounds the plant, where something does.
	 * @throws Error with the reason in plain words where the file holds none
	 */
	bounded?(specimen: S, file: File): Promise<S>;
	/**
	 * A specimen as the core's request: `model`, `seed`, `outputs`, `parameters` and what else the model asks for.
	 * @throws CoreError where the specimen cannot be written as one: it has not come through specimen/restore.ts
	 */
	encode(specimen: S, options?: GrowthOptions): Block[];
	/** What came back for a specimen, typed: plain data, for it is cloned into the worker that makes files. */
	read(answer: Answer, specimen: S): G;
	/** Whether anything of a plant depends on its age, of models whose texts may not say so; once `prepare` has been awaited. Absent: as the table has it. */
	ages?(specimen: S): boolean;
	/** What the plant is made of, for the scene and the exporters, which run in a worker: meshes or instances with their materials. */
	parts(grown: G, specimen: S): Iterable<Part>;
	/** The plant for four distances, from near to far, where it was grown with `levels`; absent of models that have none. */
	levels?(grown: G, specimen: S): readonly (readonly Part[])[];
	/** Specimens of other models in it, grown by their own cores when it has grown; absent: there are none. */
	readonly members?: Members<G>;
	/** Whether some parts are one mesh many times, or alike; where absent, whether organs are drawn with meshes says so. */
	instanced?(grown: G): boolean;
	/** What a specimen is called that is not named after its preset any more; absent or undefined: after that. */
	titled?(specimen: S): string | undefined;
	/** What grew in a few plain words, for people and screen readers: "73 berries, 22 cm long". */
	words(grown: G, specimen: S): string;
	/** What the JSON document has of it besides its segments and organs, or in their place, by key. */
	record?(grown: G, specimen: S): object;
	/** Why its JSON document with all its topology (`map`) is too large to be sent, and how to ask for less; undefined where it is not. It has grown without. */
	heavy?(grown: G): string | undefined;
	/** Descriptors with classes besides those of its measures. */
	readonly descriptors?: readonly Descriptor<S>[];
	/** How points on its plants are labelled in clouds; absent: by the kinds of its parts, as they come. */
	readonly labels?: PointLabels;
	/** What files with meshes (glTF) say of it besides what they say of every plant, by key. */
	extras?(grown: G, specimen: S): Record<string, unknown>;
	/** A grammar's text out of another form that the model claims; undefined of what is one already. Rejects with a TextError. */
	translated?(text: string): Promise<string> | undefined;
	/** Files besides those of every plant. */
	readonly formats?: readonly Format<S, G>[];

	/** What can be asked of its measures, where something can. */
	readonly targets?: Targets<S>;
}
