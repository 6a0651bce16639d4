/** The paper to cite. It has no journal and no DOI yet, so none is named. */
export const bibtex = `@misc{zhang-hexahedra,
  author = {Paul Zhang},
  title = {Validating Hexahedra through their Boundaries},
}
`
