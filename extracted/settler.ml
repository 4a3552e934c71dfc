open Certified

type diagonals = By_parity | By_key

type t = {
  diagonals : diagonals;
  thresholds : thresholds;
  lattice : Lattice.t;
  sign : signField;
  cut : cutField;
  zeros : zeros;
}

let settle ?(diagonals = By_parity) gap thresholds lattice { Domain.sign = sample; cut } =
  let sign = openSigns sample in
  let cut = openCuts sample cut in
  let order = inTurn thresholds sign cut (Lattice.points lattice) in
  { diagonals; thresholds; lattice; sign; cut; zeros = settle thresholds sign cut gap order }

let place { zeros; _ } = placeIn zeros

let names { diagonals; thresholds; sign; cut; zeros; _ } =
  match diagonals with
  | By_parity -> placedNames sign (placeIn zeros)
  | By_key -> keyNames sign (placeIn zeros) (clampedCut thresholds cut)

let iter_tets settled visit =
  Lattice.iter_tets settled.lattice (fun id -> List.iter visit (names settled id))

let position { thresholds; cut; zeros; _ } v =
  Convert.point_of_coord3
    (placedPosition (placeIn zeros) (clampedCut thresholds cut) v)

let mesh ({ thresholds; sign; cut; zeros; _ } as settled) =
  {
    tetsWithin = names settled;
    signIn = placedSign sign (placeIn zeros);
    positionIn = placedPosition (placeIn zeros) (clampedCut thresholds cut);
  }
