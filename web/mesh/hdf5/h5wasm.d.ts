/** h5wasm's module as it is used here: the HDF5 library in wasm, with Emscripten's file system. Its declarations are its own, and of more. */
declare module '*/h5wasm/dist/esm/hdf5_util.js' {
  export interface Metadata {
    /** H5T_class_t; -1 for none. */
    readonly type: number
    /** Bytes of one. */
    readonly size: number
    readonly signed: boolean
    /** True for strings of any length, which are then pointers. */
    readonly vlen: boolean
    /** Null for a dataset of nothing. */
    readonly shape: readonly number[] | null
    readonly chunks: readonly number[] | null
    readonly total_size: number
    readonly virtual_sources?: unknown
    readonly enum_type?: { readonly type: number }
    readonly array_type?: { readonly type: number; readonly size: number; readonly shape: readonly number[] }
  }

  export interface Stream {
    position: number
  }

  export interface FileNode {
    stream_ops: object
    usedBytes: number
  }

  export interface H5Module {
    readonly HEAPU8: Uint8Array
    readonly FS: {
      createFile(folder: string, name: string, properties: object, canRead: boolean, canWrite: boolean): FileNode
      unlink(path: string): void
    }
    readonly H5F_ACC_RDONLY: number
    readonly H5F_LIBVER_EARLIEST: number
    readonly H5F_LIBVER_LATEST: number
    readonly H5G_GROUP: number
    readonly H5G_DATASET: number
    /** Negative where it fails. */
    open(path: string, mode: number, tracksOrder: boolean, low: number, high: number): bigint
    close_file(file: bigint): number
    get_names(file: bigint, path: string, isRecursive: boolean): string[]
    get_type(file: bigint, path: string): number
    get_attribute_names(file: bigint, path: string): string[]
    get_attribute_metadata(file: bigint, path: string, name: string): Metadata
    get_attribute_data(file: bigint, path: string, name: string, pointer: bigint): number
    get_dataset_metadata(file: bigint, path: string): Metadata
    get_dataset_filters(file: bigint, path: string): readonly { readonly id: number; readonly name: string }[]
    get_dataset_data(
      file: bigint,
      path: string,
      count: readonly bigint[] | null,
      offset: readonly bigint[] | null,
      strides: readonly bigint[] | null,
      pointer: bigint,
    ): number
    UTF8ToString(pointer: number): string
    _malloc(bytes: number): number
    _free(pointer: number): void
  }

  export default function start(options: {
    readonly noInitialRun: boolean
    readonly print: (line: string) => void
    readonly printErr: (line: string) => void
  }): Promise<H5Module>
}
