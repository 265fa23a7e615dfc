/**
 * Specimens that a plant of another model contains (a stand): requests for them, and grown members. Types only; plain
 * data, because plants are cloned into the worker that makes files.
 */
import type { Material } from "../plant/material";
import type { PackedMesh } from "../plant/packed_mesh";
import type { Specimen } from "../specimen/specimen";

/** A position in a grammar's text; line and column count from 1. */
export interface TextPosition {
	readonly line: number;
	readonly column: number;
}

/** A specimen to be grown. */
export interface MemberRequest {
	readonly model: string;
	readonly preset: string;
	readonly seed: number;
	/** By the keys of the model's table; choices by the names of their options. */
	readonly values: Readonly<Record<string, number | string>>;
	/** The surroundings of the plant (specimen/surroundings.ts), for models that use them; absent: open ground. */
	readonly surroundings?: readonly number[];
	/** Tags of the organs whose positions the response lists; absent: none. */
	readonly spots?: readonly string[];
	/** Positions of the request and of each of its values in the text. */
	readonly place: TextPosition;
	readonly places: Readonly<Record<string, TextPosition>>;
}

/** A mesh with one material. Members that look alike share the material's object. */
export interface MemberMesh {
	readonly mesh: PackedMesh;
	readonly material: Material;
}

/** A grown member. */
export interface Member {
	readonly specimen: Specimen;
	/** The title of the member's preset. */
	readonly title: string;
	/** Query and fragment of the link that grows this member by itself. */
	readonly link: string;
	/** 16 hexadecimal digits. */
	readonly fingerprint: string;
	/** Messages of the core. */
	readonly notes: readonly string[];
	/** As in a plant (plant/plant.ts). */
	readonly cutShort?: "limit" | "time";
	/** Meshes by level of detail, from near to far: at least one, none where no meshes were requested. */
	readonly levels: readonly (readonly MemberMesh[])[];
	/** Positions of the requested organs by tag: 3 × organs, metres. */
	readonly spots?: Readonly<Record<string, Float32Array>>;
	/** Lowest and highest height, and the greatest distance from the upright axis through the base, metres. */
	readonly extent: { readonly low: number; readonly high: number; readonly out: number };
}
