import { describe, expect, it } from "vitest";
import { argumentsOf, readMessage } from "../../../wasm-core/tools/generate/icu.mjs";
import { coreCatalogues, coreRoomCode } from "../../../wasm-core/tools/generate/messages.mjs";
import recorded from "./core_arguments.json";

/** The arguments of each message of the core that has several, in the order in which the English text has them. */
function orders(): Record<string, string> {
	const several: Record<string, string> = {};
	for (const { room, messages } of coreCatalogues()) {
		for (const [key, message] of Object.entries(messages)) {
			const names = [...argumentsOf(readMessage(message as string)).keys()];
			if (names.length > 1) several[`${coreRoomCode(room)}.${key}`] = names.join(" ");
		}
	}
	return several;
}

describe("messages of the core with several arguments", () => {
	// The core passes the arguments by position: `message(messages::room::key, first, second)`.
	it("have them in the order in which the core passes them; change the calls together with core_arguments.json", () => {
		expect(orders()).toEqual(recorded);
	});
});
