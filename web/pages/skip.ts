/** The link past the lens leads to the column and leaves the address alone, which says what is in the lens. */
document.querySelector('.skip')?.addEventListener('click', event => {
  event.preventDefault()
  document.querySelector<HTMLElement>('#column')?.focus({ preventScroll: true })
})
