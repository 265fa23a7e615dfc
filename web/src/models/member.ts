/**
 * Specimens that a plant of another model has in it (a stand): what is asked for, and what came of it. Types only; plain data, for
 * plants are cloned into the worker that makes files.
 */
import type { Material } from "../plant/material";
import type { PackedMesh } from "../plant/packed_mesh";
import type { Specimen } from "../specimen/specimen";

/** Where a text asks for it; counted from 1. */
export interface TextPosition {
	readonly line: number;
	readonly column: number;
}

/** A specimen to be grown. */
export interface MemberRequest {
	readonly model: string;
	readonly preset: string;
	readonly seed: number;
	/** By the keys of its model's table; choices by the names of their options. */
	readonly values: Readonly<Record<string, number | string>>;
	/** What stands about it (specimen/surroundings.ts), for models that heed it; absent: nothing. */
	readonly surroundings?: readonly number[];
	/** Of which of its organs it is to be known where they are, by their tags; absent: of none. */
	readonly spots?: readonly string[];
	/** Where the text names it, and where each of its values. */
	readonly place: TextPosition;
	readonly places: Readonly<Record<string, TextPosition>>;
}

/** A mesh of one material. Members that look alike share the material's object. */
export interface MemberMesh {
	readonly mesh: PackedMesh;
	readonly material: Material;
}

/** One that has grown. */
export interface Member {
	readonly specimen: Specimen;
	/** Of its preset. */
	readonly title: string;
	/** Query and fragment that grow it by itself, as it is here. */
	readonly link: string;
	/** 16 hexadecimal digits. */
	readonly fingerprint: string;
	/** What its core had to say. */
	readonly notes: readonly string[];
	/** As of a plant (plant/plant.ts). */
	readonly cutShort?: "limit" | "time";
	/** Meshes for so many distances, from near to far: one at the least, but where none were asked for. */
	readonly levels: readonly (readonly MemberMesh[])[];
	/** Where the organs are that were asked for, by their tags: 3 × how many there are, metres. */
	readonly spots?: Readonly<Record<string, Float32Array>>;
	/** Lowest and highest place and the farthest from the upright axis through its foot, metres. */
	readonly extent: { readonly low: number; readonly high: number; readonly out: number };
}
