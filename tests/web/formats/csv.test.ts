import { describe, expect, it } from "vitest";
import { writeCsv } from "../../../web/src/formats/csv";

describe("writeCsv", () => {
	it("ends every row with CRLF and leaves empty what does not apply", () => {
		expect(
			writeCsv([
				["a", "b"],
				[1.5, null],
				["", 0],
			]),
		).toBe("a,b\r\n1.5,\r\n,0\r\n");
		expect(writeCsv([])).toBe("");
	});

	it("quotes what would end a cell, doubling quotes", () => {
		expect(writeCsv([['a "b", c', "d\ne", "f\rg", "h i"]])).toBe('"a ""b"", c","d\ne","f\rg",h i\r\n');
	});
});
