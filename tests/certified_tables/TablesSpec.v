(** * What the tables of the C++ side must be

    Each is computed from the certified functions.  A table that says how the
    engine names or orders things, of which the certificate has no opinion, is
    given by the rule that it follows; [CertifiedTables.v] proves what the rule
    is good for. *)

From Coq Require Import ZArith String List Bool.
From Certet Require Import Certificate.
From Certet Require Import Key.KeyStuffing.
From CertetTables Require Import Table TableRules StencilTables KeyTables EngineTables.
From CertetTables Require Import MethodTables LinkTables MaterialTables GradedTables.
Import ListNotations.
Open Scope Z_scope.

(** What makes a table right: that it is this one, or that it passes a test. *)
Definition Is (certified : Table) : Table -> bool := Equal certified.

Definition Expected : list (string * (Table -> bool)) :=
  [("case_count", Is (Count AllCases));
   ("order_1234", Is (Numbers (OrderMarks Order1234)));
   ("order_2143", Is (Numbers (OrderMarks Order2143)));
   ("structured_tet_table", Is StructuredTetTable);
   ("direction_count", Is (Count AllDirections));
   ("direction_offset", Is (OfDirections (fun d => Point (Offset d))));
   ("lattice_tiling", Is LatticeTilingTable);
   ("pattern_count", Is (Number (Z.of_nat PatternCount)));
   ("stencil_table", Is StencilTable);
   ("cut_order_count", Is (Number 16));
   ("key_stencil_count", Is (Number 128));
   ("cut_orders", Is CutOrdersTable);
   ("key_stencil_table", Is KeyStencilTable);
   ("moved_corner", Is (Number MovedCorner));
   ("shared_owner", Is (Number 4));
   ("likeness_count", Is (Number (Z.of_nat LikenessCount)));
   ("material_pattern_count", Is (Count MaterialPatternList));
   ("material_patterns", Is (Row (map Numbers MaterialPatternList)));
   ("pattern_of_likeness", Is PatternOfLikeness);
   ("material_stencil_table", Is (Row (map MaterialStencilEntry MaterialPatternList)));
   ("least_angle", Is (fst LeastAndGreatest));
   ("greatest_angle", Is (snd LeastAndGreatest));
   ("step_bits", Is (Number (Z.of_nat StepBits)));
   ("steps", Is (Number Steps));
   ("core::midpoint_cut", Is (Number MidpointCut));
   ("threshold_denominator", IsDenominator);
   ("angle_thresholds", Is (ThresholdsEntry AngleThresholds));
   ("embedding_thresholds", Is (ThresholdsEntry EmbeddingThresholds));
   ("no_warp_thresholds", Is (ThresholdsEntry NoWarpThresholds));
   ("key_thresholds", Is (ThresholdsEntry KeyThresholds));
   ("methods", AreMethods);
   ("core::whole_link", Is (Number (SetNumber (Gather (fun _ => true)))));
   ("core::link_ring", Is LinkRings);
   ("core::link_triangles", Is LinkTriangles);
   ("core::long_link_edges", Is LongLinkEdges);
   ("core::connected_sets", Is ConnectedSets);
   ("core::grid_count", Is (Count Grids));
   ("core::grids", Is (Numbers (Upto (length Grids))));
   ("core::corner_kinds", Is (Number CornerKinds));
   ("core::family_count", Is (Count Families));
   ("core::kind_count", Is (Number (CornerKinds + Z.of_nat (length Families))));
   ("core::families", Is (Row (map (fun f => Row (map VertexEntry (Ends f))) Families)));
   ("core::edges_of", Is EdgesOf);
   ("core::family_directions", Is FamilyDirections);
   ("core::edge_end_count", Is (Count EdgeEndsList));
   ("core::edge_ends", Is EdgeEnds);
   ("core::cell_tet_count", Is (Count AllCases));
   ("core::cell_vertex_count", Is (Count CellVertices));
   ("core::cell", Is CellTable);
   ("core::output_orders", Is (Row (map (fun c => Numbers (OutputOrder c)) AllCases)));
   ("core::interior_size", Is (Count InteriorVertices));
   ("core::interior_vertices", Is (Numbers InteriorVertices));
   ("core::graded_kinds", Is (Numbers (Upto (length GradedKinds))));
   ("core::flag_count", Is (Count FlagsOfCell));
   ("core::flags", Is (Row (map FlagEntry FlagsOfCell)));
   ("core::graded_tets", Is (OfFlags GradedTetEntry GradedKinds));
   ("coordinate_limit", Is (Number LatticeLimit));
   ("anchor_limit", Is (Number AnchorLimit));
   ("cells_limit", IsCellsLimit);
   ("core::edge_limit", Is (Number WidthLimit));
   ("core::outward_faces", AreOutwardFaces);
   ("signs", Is (Numbers (map SignNumber AllSigns)));
   ("sign_of_bits", Is (Numbers (map SignNumber AllSigns)));
   ("opposite", Is (Row (map (fun a => Row (map (fun b => Truth (Opposite a b)) AllSigns))
                           AllSigns)));
   ("pattern_signs", Is PatternSigns);
   ("pattern_index", Is (Numbers (Upto PatternCount)));
   ("cases", Is (Numbers (map CaseNumber AllCases)));
   ("right_handed", Is (Row (map (fun c => Truth (IsRightHanded c)) AllCases)));
   ("is_long", Is (OfDirections (fun d => Truth (IsLong (DirectionKind d)))));
   ("length_squared", Is (OfDirections (fun d => Number (LengthSquared (DirectionKind d)))));
   ("thresholds_in_steps",
      Is (Row (map StepsEntry [AngleThresholds; EmbeddingThresholds; NoWarpThresholds;
                               KeyThresholds])));
   ("core::names_tet",
      Is (OfFlags (fun kind x => Truth (IsName kind x)) (removelast GradedKinds)));
   ("core::neighbor", Is Neighbors)]%string.
