import { expect, it } from "vitest";
import { printable } from "../../../web/src/cli/printable";
import { grow } from "./world";

it("writes control characters of a quoted text as escapes, and keeps lines and letters", () => {
	expect(printable("grow: “\u001b[2Jα\u009b31m\u202e” is no preset\nÅ 葡萄")).toBe(
		"grow: “\\u{1b}[2Jα\\u{9b}31m\\u{202e}” is no preset\nÅ 葡萄",
	);
});

it("cuts long lines", () => {
	expect(printable("grow: g.lsys:2:9: no\n  \tA\n  \t^")).toBe("grow: g.lsys:2:9: no\n  \tA\n  \t^");
	expect(printable(`${"x".repeat(200_000)}\nend`)).toBe(`${"x".repeat(1000)}…\nend`);
});

it("is what the command prints of its errors", async () => {
	const name = `\u001b[2J${"x".repeat(5000)}.glb`;
	const { status, messages } = await grow(["riesling", "--out", `nowhere/${name}`, "--set", "count=5"]);
	expect(status).not.toBe(0);
	expect(messages.join()).toMatch(/\\u\{1b\}\[2Jx{900}/);
	expect(messages.join().length).toBeLessThan(1100);
});
