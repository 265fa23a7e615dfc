/** The part of assimpjs that the tests use, since it has no types: the Assimp library as WebAssembly. */
declare module "assimpjs" {
	interface Assimp {
		FileList: new () => { AddFile(name: string, content: Uint8Array): void };
		ConvertFileList(files: InstanceType<Assimp["FileList"]>, format: "assjson"): AssimpResult;
	}
	interface AssimpResult {
		IsSuccess(): boolean;
		GetErrorCode(): string;
		GetFile(index: number): { GetContent(): Uint8Array };
	}
	export default function assimpjs(): Promise<Assimp>;
}
