/* F itself: a point's image in physical space. */
#ifndef HL_MAP_H
#define HL_MAP_H

/* F(point) for a point of [0,1]^3; never outside the bounding box of the vertices. */
void map_point(const double vertices[24], const double point[3], double position[3]);

#endif
