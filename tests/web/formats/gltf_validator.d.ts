/** The part of Khronos' validator that the tests use; it ships no types. */
declare module "gltf-validator" {
	export interface Issue {
		code: string;
		message: string;
		/** 0 error, 1 warning, 2 information, 3 hint. */
		severity: number;
		pointer?: string;
	}
	export interface Report {
		issues: { numErrors: number; numWarnings: number; numInfos: number; numHints: number; messages: Issue[] };
		info: { generator?: string; drawCallCount: number; totalVertexCount: number; totalTriangleCount: number };
	}
	export function validateBytes(data: Uint8Array, options?: { maxIssues?: number }): Promise<Report>;
}
