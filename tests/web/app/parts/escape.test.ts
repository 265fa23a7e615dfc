/** Parts of the page that handle Escape prevent its default, so that tools listening on the window ignore it. */
import type { TemplateResult } from "lit";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Gallery } from "../../../../web/src/app/parts/gallery";
import type { Studio } from "../../../../web/src/app/studio";
import { specimenFromPreset } from "../../bunch";
import { sampleBunch } from "../../models/bunch/sample_bunch";
import { studioWith } from "../context";

const field = { focus: vi.fn() };
let studio: Studio;
beforeEach(async () => {
	vi.stubGlobal("window", new EventTarget());
	vi.stubGlobal("document", { activeElement: null });
	({ studio } = await studioWith(specimenFromPreset()));
	studio.grew({ ...sampleBunch(5), measures: new Float32Array([1]) }, studio.state.specimen);
	field.focus.mockClear();
});
afterEach(() => vi.unstubAllGlobals());

/** A part outside a page; every query for an element in it returns the field. */
function placed<P extends Gallery>(part: P): P {
	Object.assign(part, {
		performUpdate: () => {},
		querySelector: () => field,
		querySelectorAll: () => [],
		context: studio,
	});
	return part;
}

type Listener = (this: unknown, event: unknown) => unknown;

/** The listener that a part draws after markup with this ending; undefined if it is not drawn. */
function heard(drawn: unknown, ending: RegExp): Listener | undefined {
	if (Array.isArray(drawn)) return drawn.map((each) => heard(each, ending)).find(Boolean);
	const { strings, values } = (drawn ?? {}) as Partial<TemplateResult>;
	if (!strings || !values) return undefined;
	const at = strings.findIndex((text, i) => i < values.length && ending.test(text));
	return at < 0 ? values.map((value) => heard(value, ending)).find(Boolean) : (values[at] as Listener);
}
const drawnBy = (part: Gallery) => (part as unknown as { draw(studio: Studio): unknown }).draw(studio);

function press(part: Gallery, ending: RegExp, key: string): Event {
	const event = Object.assign(new Event("keydown", { cancelable: true }), { key });
	heard(drawnBy(part), ending)?.call(part, event);
	return event;
}

it("Escape moves the focus from the presets to the button that opens the gallery; other keys are left alone", () => {
	const gallery = placed(new Gallery());
	const keys = /class="strip" role="group" @keydown=$/;
	expect(press(gallery, keys, "n").defaultPrevented).toBe(false);
	expect(field.focus).not.toHaveBeenCalled();
	expect(press(gallery, keys, "Escape").defaultPrevented).toBe(true);
	expect(field.focus).toHaveBeenCalledOnce();
});
