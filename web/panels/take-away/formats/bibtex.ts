/** How to cite the paper. It has no journal and no DOI here yet, so none is named. */
export const bibtex = `@misc{zhang-hexahedra,
  author = {Paul Zhang},
  title = {Validating Hexahedra through their Boundaries},
}
`
