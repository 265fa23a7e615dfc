import { expect, it } from "vitest";
import { shortcutGroups } from "../../../../web/src/app/help/shortcut_list";
import type { StudioState } from "../../../../web/src/app/studio_state";
import { specimenFromPreset } from "../../bunch";
import { studioWith } from "../context";

const keysIn = (state: StudioState, group?: string) =>
	shortcutGroups(state)
		.filter(({ key }) => group === undefined || key === group)
		.flatMap(({ shortcuts }) => shortcuts.map(({ keys }) => keys.join()));

it("lists the page's keys and the model's, each letter once", async () => {
	const { studio } = await studioWith(specimenFromPreset());
	const keys = keysIn(studio.state);
	for (const key of ["Ctrl+Z", "Ctrl+Shift+Z,Ctrl+Y", "F1", "N", "S", "O", "T", "K", "?"]) expect(keys).toContain(key);
	const letters = keys.filter((key) => key.length === 1);
	expect(new Set(letters).size).toBe(letters.length);
});

it("groups the shortcuts: those of the page, the view, the controls and the model's tools", async () => {
	const { studio } = await studioWith(specimenFromPreset());
	expect(shortcutGroups(studio.state).map(({ key }) => key)).toEqual(["general", "view", "controls", "tools"]);
	expect(keysIn(studio.state, "general")).toEqual(expect.arrayContaining(["Ctrl+K", "N", "?", "F1", "Esc"]));
	expect(keysIn(studio.state, "view")).toContain("+,−,0");
	expect(keysIn(studio.state, "controls")).toContain("Delete");
	expect(keysIn(studio.state, "tools")).toEqual(expect.arrayContaining(["T", "O"]));
	expect(shortcutGroups({ ...studio.state, modelUi: undefined }).map(({ key }) => key)).not.toContain("tools");
});

it("lists no single letters or signs while these are switched off", async () => {
	const { studio } = await studioWith(specimenFromPreset());
	studio.setUi({ letters: false });
	const keys = keysIn(studio.state);
	for (const key of ["N", "T", "?", "/"]) expect(keys).not.toContain(key);
	for (const key of ["Ctrl+Z", "F1", "Esc"]) expect(keys).toContain(key);
});
