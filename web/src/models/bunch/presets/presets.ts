import { numbersIn, type Preset, type PresetKind } from "../../../specimen/presets";
import type { NumberKey } from "../parameters.generated";
import { BUNCH_TABLE } from "../table";
import cylindrical from "./cylindrical.json";
import doubleBunchWinged from "./double-bunch-winged.json";
import duku from "./duku.json";
import grape15a from "./grape-15a.json";
import grape15b from "./grape-15b.json";
import grape15c from "./grape-15c.json";
import grape15d from "./grape-15d.json";
import longConical from "./long-conical.json";
import longan from "./longan.json";
import lychee from "./lychee.json";
import redcurrant from "./redcurrant.json";
import rubus from "./rubus.json";
import shortConical from "./short-conical.json";
import shoulderedConical from "./shouldered-conical.json";
import cabernetSauvignon from "./varieties/cabernet-sauvignon.json";
import chardonnay from "./varieties/chardonnay.json";
import concord from "./varieties/concord.json";
import crimsonSeedless from "./varieties/crimson-seedless.json";
import gewurztraminer from "./varieties/gewurztraminer.json";
import kyoho from "./varieties/kyoho.json";
import merlot from "./varieties/merlot.json";
import muscatOfAlexandria from "./varieties/muscat-of-alexandria.json";
import pinotNoir from "./varieties/pinot-noir.json";
import pizzutello from "./varieties/pizzutello.json";
import redGlobe from "./varieties/red-globe.json";
import riesling from "./varieties/riesling.json";
import shineMuscat from "./varieties/shine-muscat.json";
import syrah from "./varieties/syrah.json";
import tempranillo from "./varieties/tempranillo.json";
import thompsonSeedless from "./varieties/thompson-seedless.json";
import wingedCylindrical from "./winged-cylindrical.json";

/**
 * Kinds of presets. Shapes and fruits have the profiles of Table 3 (Huang et al. 2013); docs/varieties.md lists the
 * sources of varieties.
 *
 * The paper describes the double bunch winged only as two bunches. Ours keeps the first one's left side narrow and
 * sends the second out over it, sagging: in the paper's procedure, a second bunch that meets the axes of the first
 * finds no room and is cut.
 */
export const PRESET_KINDS = [
	{ key: "shape", title: "Shapes", family: "grapes" },
	{ key: "variety", title: "Varieties", family: "grapes" },
	{ key: "fruit", title: "Other fruits", family: "grapes" },
	{ key: "figure", title: "Figures of the paper", family: "grapes", fromPaper: true },
] as const satisfies readonly PresetKind[];

/** A preset's file, which stores choices by name. */
interface PresetFile extends Omit<Preset, "kind" | "parameters"> {
	parameters: Readonly<Partial<Record<NumberKey, number | string>>>;
}

/** All presets. */
export const PRESETS: readonly Preset[] = [
	...ofKind("shape", [shortConical, shoulderedConical, longConical, cylindrical, wingedCylindrical, doubleBunchWinged]),
	...ofKind("figure", [grape15a, grape15b, grape15c, grape15d]),
	...ofKind("fruit", [redcurrant, rubus, lychee, longan, duku]),
	...ofKind("variety", [
		pinotNoir,
		riesling,
		gewurztraminer,
		cabernetSauvignon,
		merlot,
		chardonnay,
		tempranillo,
		syrah,
		concord,
		muscatOfAlexandria,
		thompsonSeedless,
		crimsonSeedless,
		redGlobe,
		kyoho,
		shineMuscat,
		pizzutello,
	]),
];

/** Returns the presets of a kind from their files, with choices as numbers. */
function ofKind(kind: (typeof PRESET_KINDS)[number]["key"], files: readonly PresetFile[]): Preset[] {
	// Varieties were added with the natural procedure.
	const since = kind === "variety" ? { since: 2 } : {};
	return files.map((file) => ({ ...file, ...since, kind, parameters: numbersIn(BUNCH_TABLE, file.parameters) }));
}

/** Preset of a link without `preset`. */
export const DEFAULT_PRESET = "long-conical";
