/**
 * The library: grows specimens of every model, and makes their files, without a page.
 *
 * @packageDocumentation
 */
export { CoreError, type CoreReason, CoreTrap, UnsupportedError } from "../core/errors";
export type { FileOptions } from "../formats/file_options";
export type { FileVector as Vector, OrganRecord, SegmentRecord } from "../formats/json";
export type { Colour } from "../plant/colour";
export type {
	Chance,
	DerivationTrace as Chronicle,
	ModuleAnswer,
	ModuleSpan,
	Refusal,
	TextPlace,
	TraceEntry,
} from "../plant/derivation_trace";
export type { Material, Picture, Textures } from "../plant/material";
export type { Extras, Instances, Part, PartMesh, Shape } from "../plant/part";
export type { Mesh, MeshRun, Organs, Plant, PlantMesh, Segments } from "../plant/plant";
export {
	type FormatInfo,
	formats,
	type MeasureInfo,
	type ModelInfo,
	measures,
	models,
	type ParameterInfo,
	type PresetInfo,
	parameters,
	presets,
} from "./catalogue";
export {
	type GlbForm,
	type GlbOptions,
	type ObjFiles,
	type PlantDocument,
	partsOf,
	to3MF,
	toFile,
	toGLB,
	toJSON,
	toOBJ,
	toPLY,
	toSTL,
	toUSDZ,
} from "./files";
export { type Grown, type GrowOptions, grow, type PlantRequest as Asked, type Specimen, type Values } from "./grow";
export { formatLink, type ParsedLink, parseLink } from "./links";
export { SpecimenError } from "./read_request";
