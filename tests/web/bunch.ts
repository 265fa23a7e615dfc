/** Reading and writing documents of the bunch: the functions of specimen/, bound to this model. */

import { aboutPlant } from "../../web/src/formats/about_plant";
import * as json from "../../web/src/formats/json";
import { foundInFile } from "../../web/src/formats/restore";
import type { BunchPlant } from "../../web/src/models/bunch/bunch_plant";
import { model } from "../../web/src/models/bunch/index";
import { PRESETS } from "../../web/src/models/bunch/presets/presets";
import { BUNCH } from "../../web/src/models/bunch/schema";
import type { BunchSpecimen, Look } from "../../web/src/models/bunch/specimen";
import * as edit from "../../web/src/specimen/edit";
import * as link from "../../web/src/specimen/link";
import type { Preset } from "../../web/src/specimen/presets";
import * as restored from "../../web/src/specimen/restore";
import type { CoreEntry, ParameterEntry } from "../../web/src/specimen/table";
import * as written from "../../web/src/specimen/written";
import { namesInRun } from "../long_run.mjs";

export {
	BERRY_IDS,
	MAX_THINNED,
	thin,
	unthin,
	unthinAll,
} from "../../web/src/models/bunch/details/thinned";
export { BUNCH, specimenFromPreset } from "../../web/src/models/bunch/schema";
export type { BunchSpecimen as Specimen, Look };

export const ENTRIES: readonly ParameterEntry[] = BUNCH.table.entries;
export const CORE_ENTRIES: readonly CoreEntry[] = BUNCH.table.core;
export const entryOf = (key: string) => BUNCH.table.entry(key);
/** The presets of the gate: shapes without and with wings, a fruit, varieties set by density and by a count of berries. */
const GATE_PRESETS = ["short-conical", "double-bunch-winged", "rubus", "riesling", "kyoho"];

/** Names of the presets that a sweep over presets grows: a few in the gate, all in the long run. */
export const presetsInRun = (isWanted: (preset: Preset) => boolean = () => true): readonly string[] =>
	namesInRun(
		PRESETS.filter(isWanted).map(({ name }) => name),
		GATE_PRESETS,
	);

export const presetNamed = (name: string) => BUNCH.presets.named(name);

export const restore = (record: unknown, from?: BunchSpecimen) => restored.restore(BUNCH, record, from);
export const writtenSpecimen = (specimen: BunchSpecimen) => written.writtenSpecimen(BUNCH, specimen);

export const withParameters = (specimen: BunchSpecimen, changes: Partial<BunchSpecimen["parameters"]>) =>
	edit.withParameters(BUNCH, specimen, changes);
export const withLook = (specimen: BunchSpecimen, changes: Partial<Look>) => edit.withLook(BUNCH, specimen, changes);

export const encodeLink = (specimen: BunchSpecimen) => link.encodeLink(BUNCH, specimen);
export const encodeQuery = (specimen: BunchSpecimen) => link.encodeQuery(BUNCH, specimen);
export const decodeLink = (search: string, hash?: string) => link.decodeLink(BUNCH, search, hash);
export const decodeQuery = (search: string) => link.decodeQuery(BUNCH, search);

export const specimenFromFile = async (name: string, file: Blob) => {
	const found = await foundInFile(name, file);
	if ("record" in found) return restore(found.record);
	if ("library" in found) throw new Error(`${name} holds many.`);
	const { query, fragment } = link.linkParts(found.link);
	return decodeLink(query, fragment);
};

export const exportJson = (grown: BunchPlant, specimen: BunchSpecimen) => json.exportJson(model, grown, specimen);
/** Its text, as it is written without the document. */
export const writtenJson = (grown: BunchPlant, specimen: BunchSpecimen) =>
	json.writeJson(model, grown, specimen).toString();
export const aboutBunch = (grown: BunchPlant, specimen: BunchSpecimen, link?: string) =>
	aboutPlant(model, grown, specimen, link);
