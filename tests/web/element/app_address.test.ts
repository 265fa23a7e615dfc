import { afterEach, describe, expect, it, vi } from "vitest";

async function addressIn(mode: string, attribute: string | null): Promise<string | undefined> {
	vi.stubEnv("MODE", mode);
	vi.stubGlobal("document", { baseURI: "https://a.page/course/" });
	vi.resetModules();
	return (await import("../../../web/src/element/app_address")).appAddress(attribute);
}

afterEach(() => {
	vi.unstubAllEnvs();
	vi.unstubAllGlobals();
});

describe("where Open in the app leads", () => {
	it("is the folder that built scripts lie in a folder of", async () => {
		expect(await addressIn("production", null)).toMatch(/\/web\/src\/$/);
		expect(await addressIn("production", "../other/")).toMatch(/\/web\/other\/$/);
	});

	it("is nowhere for the package's element, beside which no app lies", async () => {
		expect(await addressIn("package", null)).toBeUndefined();
		expect(await addressIn("package", "../app/")).toBe("https://a.page/app/");
	});

	it("is no script and no data: only addresses of HTTP lead anywhere", async () => {
		for (const mode of ["production", "package"])
			for (const attribute of [
				"javascript:alert(1)//",
				" JavaScript:alert(1)",
				"data:text/html,x",
				"blob:https://a.page/1",
				"mailto:a@b",
			])
				expect(await addressIn(mode, attribute)).toBeUndefined();
	});

	it("is nowhere where that is what a page says, or says what is no address", async () => {
		for (const mode of ["production", "package"]) {
			expect(await addressIn(mode, "")).toBeUndefined();
			expect(await addressIn(mode, "https://")).toBeUndefined();
		}
	});
});
