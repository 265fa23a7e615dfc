import { describe, expect, it } from "vitest";
import { formatLength } from "../../../../web/src/app/view/length";
import { languageOf, useLanguage } from "../../../../web/src/locale/locale";

describe("formatLength", () => {
	it.each([
		[0.00056, "0.56 mm"],
		[0.00999, "9.99 mm"],
		[0.009996, "1 cm"],
		[0.1234, "12.3 cm"],
		[0.9996, "1 m"],
		[12.34, "12.3 m"],
	])("writes %d m as %s", (metres, words) => {
		expect(formatLength(metres)).toBe(words);
	});

	it("uses the decimal sign of the language", async () => {
		await useLanguage(languageOf("fr") as NonNullable<ReturnType<typeof languageOf>>);
		expect(formatLength(0.1234)).toMatch(/^12,3\scm$/);
		await useLanguage(languageOf("en") as NonNullable<ReturnType<typeof languageOf>>);
	});
});
