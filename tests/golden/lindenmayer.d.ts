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
	/** The part of the library that tests use: strings of modules, and productions as functions. */
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
