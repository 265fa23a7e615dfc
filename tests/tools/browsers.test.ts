import { chmodSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { find, prepareBrowsers } from "../browsers/browsers.mjs";

let machine: string;
let env: NodeJS.ProcessEnv;

beforeEach(() => {
	machine = mkdtempSync(join(tmpdir(), "browsers-"));
	env = { PATH: machine, MESA: machine };
});
afterEach(() => rmSync(machine, { recursive: true }));

/** Puts programs on the pretended machine. */
function have(...names: string[]): void {
	mkdirSync(machine, { recursive: true });
	for (const name of names) {
		writeFileSync(join(machine, name), "");
		chmodSync(join(machine, name), 0o755);
	}
}

const SCREEN = ["Xvfb", "libEGL_mesa.so.0"];
const quiet = () => {};
const never = () => Promise.reject(new Error("nothing is to be installed"));

describe("browsers besides Chromium", () => {
	it("are taken from the machine where they are there", async () => {
		have("firefox-esr", "firefox", "WebKitWebDriver", ...SCREEN);
		expect(await prepareBrowsers({ env, install: never })).toEqual({ there: ["firefox", "webkit"], without: [] });
		expect(find("firefox", env)).toBe(join(machine, "firefox-esr"));
	});

	it("are installed by apt, with what shows them, each by itself", async () => {
		have("apt-get", "firefox-esr");
		const asked: string[][] = [];
		const install = async (packages: string[]) => {
			asked.push(packages);
			if (packages.includes("xvfb")) have(...SCREEN);
			return packages.includes("webkit2gtk-driver") ? { why: "and it is unknown", unfit: packages } : null;
		};
		expect(await prepareBrowsers({ env, install, log: quiet })).toEqual({
			there: ["firefox"],
			without: ["WebKit is not tested: it is not there and it is unknown."],
		});
		expect(asked).toEqual([["xvfb", "libegl1", "libgl1-mesa-dri"], ["webkit2gtk-driver"]]);
	});

	it("are named in a line where there is no apt, and the tests go on with the others", async () => {
		have("WebKitWebDriver", ...SCREEN);
		expect(await prepareBrowsers({ env, install: never })).toEqual({
			there: ["webkit"],
			without: ["Firefox is not tested: this machine lacks firefox-esr."],
		});
		expect(() => find("firefox", env)).toThrow("npm test -- browsers");
	});
});
