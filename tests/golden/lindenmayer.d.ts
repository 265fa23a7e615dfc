declare module "lindenmayer" {
	/** A module of a string. */
	export interface Part {
		symbol: string;
		params: number[];
	}
	interface Where {
		direction: "left" | "right";
		match: string[];
		index: number;
		ignoredSymbols: string[];
		branchSymbols: string[];
	}
	/** What of the library the tests use: strings of parts, productions that are functions. */
	export default class LSystem {
		constructor(options: { axiom: Part[]; allowClassicSyntax: boolean });
		setProduction(
			symbol: string,
			production: (at: { index: number; currentAxiom: Part[]; part: Part }) => Part[] | Part,
		): void;
		iterate(steps: number): void;
		getRaw(): Part[];
		match(where: Where): { result: boolean; matchIndices: number[] };
	}
}
