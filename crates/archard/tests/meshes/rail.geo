// A rail of 16 x 16 x 8 mm, its top at z = 0, with a zone of 0.54 x 0.5 mm in the middle of it, all in triangles.
// Files are made by ./make
SetFactory("OpenCASCADE");
Box(1) = {-8, -8, -8, 16, 16, 8};
Rectangle(100) = {-0.27, -0.25, 0, 0.54, 0.5};
BooleanFragments{ Volume{1}; Delete; }{ Surface{100}; Delete; }
all() = Surface{:};
zone() = Surface In BoundingBox{-0.28, -0.26, -0.01, 0.28, 0.26, 0.01};
bottom() = Surface In BoundingBox{-8.1, -8.1, -8.1, 8.1, 8.1, -7.9};
rest() = all();
rest() -= zone();
rest() -= bottom();
Physical Surface("zone") = zone();
Physical Surface("bottom") = bottom();
Physical Surface("rest") = rest();
MeshSize{ PointsOf{ Volume{:}; } } = 8;
MeshSize{ PointsOf{ Surface{zone()}; } } = 0.05;
Mesh.Algorithm = 6;
