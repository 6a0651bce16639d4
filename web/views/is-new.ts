const last = new WeakMap<object, readonly unknown[]>()

/** True if any value differs from the last call's for this owner, or in the first call. */
export function isNew(owner: object, ...values: readonly unknown[]): boolean {
  const before = last.get(owner)
  last.set(owner, values)
  return before === undefined || values.some((value, i) => value !== before[i])
}
