import { describe, expect, it } from "vitest";
import { unitsOf } from "../../wasm-core/tools/lint.mjs";

describe("the files that clang-tidy checks for a change", () => {
	const units = ["wasm-core/src/mesh/tube.cpp", "wasm-core/src/plant/grow.cpp"];
	const texts: Record<string, string> = {
		"wasm-core/src/mesh/tube.cpp": '#include "mesh/tube.hpp"\n',
		"wasm-core/src/plant/grow.cpp": '#include "mesh/tube.hpp"\n#include "protocol/request.hpp"\n',
	};
	const of = (...changed: string[]) => unitsOf(changed, units, (path: string) => texts[path]);

	it("are changed sources themselves, and the source of the same name or one that includes it for a header", () => {
		expect(of("wasm-core/src/plant/grow.cpp")).toEqual(["wasm-core/src/plant/grow.cpp"]);
		expect(of("wasm-core/src/mesh/tube.hpp")).toEqual(["wasm-core/src/mesh/tube.cpp"]);
		expect(of("wasm-core/src/protocol/request.hpp")).toEqual(["wasm-core/src/plant/grow.cpp"]);
	});

	it("are listed once, and leave out what is not of the core or not compiled", () => {
		expect(of("wasm-core/src/mesh/tube.hpp", "wasm-core/src/mesh/tube.cpp")).toEqual(["wasm-core/src/mesh/tube.cpp"]);
		expect(
			of("web/src/app.ts", "tests/core/mesh_test.cpp", "wasm-core/src/new.cpp", "wasm-core/src/unused.hpp"),
		).toEqual([]);
	});
});
