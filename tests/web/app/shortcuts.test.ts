import { expect, it } from "vitest";
import { shortcuts } from "../../../web/src/app/shortcut_list";
import { specimenFromPreset } from "../bunch";
import { studioWith } from "./context";

it("lists the page's keys and the model's, each letter once", async () => {
	const { studio } = await studioWith(specimenFromPreset());
	const keys = shortcuts(studio.state).map((shortcut) => shortcut.keys.join());
	for (const key of ["Ctrl+Z", "N", "S", "O", "T", "K", "?"]) expect(keys).toContain(key);
	const letters = keys.filter((key) => key.length === 1);
	expect(new Set(letters).size).toBe(letters.length);
	studio.setUi({ letters: false });
	expect(shortcuts(studio.state).flatMap((shortcut) => shortcut.keys)).not.toEqual(expect.arrayContaining(["N"]));
	expect(shortcuts({ ...studio.state, modelUi: undefined }).map((shortcut) => shortcut.keys.join())).not.toContain("T");
});
