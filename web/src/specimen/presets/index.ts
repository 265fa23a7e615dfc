import type { NumberKey } from "../parameters.generated";
import type { Look } from "../specimen";
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
import wingedCylindrical from "./winged-cylindrical.json";

/**
 * A named bunch to start from. Profiles are the rows of Table 3 (Huang et al. 2013); a preset holds only what
 * differs from the defaults of the parameter table. Links hold only what differs from their preset, so what a
 * published preset says never changes.
 *
 * The paper leaves the double bunch winged at being two bunches. Ours keeps the first one's left side narrow and sends
 * the second out over it, sagging: a second bunch that meets the axes of the first finds no room and is cut.
 */
export interface Preset {
	/** As in links and on the command line. */
	name: string;
	title: string;
	/** The paper's figure. */
	figure: string;
	/** One line about the shape. */
	about: string;
	parameters: Partial<Record<NumberKey, number>>;
	look: Partial<Look>;
}

/** All presets, in the order of the gallery. */
export const PRESETS: readonly Preset[] = [
	shortConical,
	shoulderedConical,
	longConical,
	cylindrical,
	wingedCylindrical,
	doubleBunchWinged,
	grape15a,
	grape15b,
	grape15c,
	grape15d,
	redcurrant,
	rubus,
	lychee,
	longan,
	duku,
];

/** The preset a link without `preset` means. */
export const DEFAULT_PRESET = "long-conical";

const byName = new Map(PRESETS.map((preset) => [preset.name, preset]));

/** The preset of that name, if there is one. */
export function presetNamed(name: string): Preset | undefined {
	return byName.get(name);
}
